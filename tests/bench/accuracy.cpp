#include "tests/bench/accuracy.hpp"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <opencv2/video/tracking.hpp>
#include <random>

#include "services/mark-detector/mark_detector.hpp"
#include "services/target-locator/image/colour_projection.hpp"
#include "services/target-locator/mark_locator.hpp"
#include "tests/bench/match_bound.hpp"
#include "tests/scenes/mark_stage.hpp"
#include "tests/scenes/observation.hpp"

namespace markservo::bench {
namespace {

using scenes::Surface;
using target_locator::Location;
using target_locator::Mask;
using target_locator::Match;

constexpr int kFlowWindow = 11;       // px
constexpr double kFlowRanAway = 2.0;  // px off the truth: not counted against PyrLK

// Errors (px) of one case as they come.
struct Collected {
  std::vector<double> errors;
  std::vector<double> bounds;
  std::vector<double> converged_errors;
  std::vector<double> plane_errors;
  std::vector<double> plane_bounds;
  std::vector<double> flow_errors;
  std::vector<double> errors_where_flow;
};

double rms(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double value : values) sum += value * value;
  return values.empty() ? 0.0 : std::sqrt(sum / static_cast<double>(values.size()));
}

double mean_absolute(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double value : values) sum += std::abs(value);
  return values.empty() ? 0.0 : sum / static_cast<double>(values.size());
}

double p95_absolute(std::vector<double> values) {
  if (values.empty()) return 0.0;
  for (double& value : values) value = std::abs(value);
  const auto at = static_cast<std::size_t>(0.95 * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(at), values.end());
  return values[at];
}

// Slope of the surface's disparity along the rows, px per px.
double slope(const Surface& surface, const geometry::StereoCamera& camera) {
  return surface.disparity(camera, 1.0, 0.0) - surface.disparity(camera, 0.0, 0.0);
}

// The mark anywhere between 220 and 300 mm, turned about the vertical until its disparity has that slope.
Surface place_mark(const robot::RobotDescription& robot, const robot::MarkDescription& mark, double wanted_slope,
                   bool even_print, std::mt19937& random) {
  const auto draw = [&](double low, double high) { return std::uniform_real_distribution<double>(low, high)(random); };
  const robot::CameraDescription& cameras = robot.cameras;
  const Eigen::Vector3d centre = scenes::point_at(cameras.stereo, draw(0.50, 0.85) * cameras.width,
                                                  draw(0.2, 0.8) * cameras.height, draw(0.22, 0.30));
  const auto seed = static_cast<unsigned>(random());
  const double roll_deg = draw(-10.0, 10.0);
  const auto turned = [&](double yaw_deg) {
    Surface surface = scenes::mark_surface(mark, centre, {yaw_deg, 0.0, roll_deg}, seed);
    surface.even = even_print;
    return surface;
  };
  double low = -45.0;
  double high = 45.0;
  const bool rising = slope(turned(high), cameras.stereo) > slope(turned(low), cameras.stereo);
  for (int k = 0; k < 40; ++k) {
    const double middle = 0.5 * (low + high);
    const bool below = slope(turned(middle), cameras.stereo) < wanted_slope;
    (below == rising ? low : high) = middle;
  }
  return turned(0.5 * (low + high));
}

NoiseFreeView noise_free(const scenes::StagedView& view, const target_locator::Patch& patch,
                         const target_locator::ColourMap& axis) {
  NoiseFreeView result{target_locator::PlaneImage(patch.width, patch.height),
                       target_locator::PlaneImage(patch.width, patch.height)};
  const cv::Rect cut(static_cast<int>(patch.frame.x) - view.drawn.x, static_cast<int>(patch.frame.y) - view.drawn.y,
                     patch.width, patch.height);
  const cv::Rect all(0, 0, view.drawn.width, view.drawn.height);
  for (int y = 0; y < patch.height; ++y) {
    for (int x = 0; x < patch.width; ++x) {
      const cv::Point at = cut.tl() + cv::Point(x, y);
      if (!all.contains(at)) continue;  // margin, of which no window has anything
      const cv::Vec3f& colour = view.clean(at);
      const cv::Vec3f& change = view.clean_change_along_u(at);
      const auto project = [&axis](const cv::Vec3f& bgr) {
        return axis.weights[0] * bgr[0] + axis.weights[1] * bgr[1] + axis.weights[2] * bgr[2];
      };
      result.grey.at(x, y) = project(colour);
      result.change_along_u.at(x, y) = project(change);
    }
  }
  return result;
}

// The pixels of the locator's window about a match.
Mask window_about(const Mask& mask, int column, int row, int half) {
  Mask window(mask.width(), mask.height());
  for (int y = std::max(0, row - half); y <= std::min(mask.height() - 1, row + half); ++y) {
    // The outermost columns have no gradient.
    for (int x = std::max(1, column - half); x <= std::min(mask.width() - 2, column + half); ++x) {
      window.set(x, y, mask.test(x, y));
    }
  }
  return window;
}

void add_flow(const scenes::StagedPair& pair, const std::vector<Match>& matches, const Surface& mark,
              const geometry::StereoCamera& camera, Collected& collected) {
  if (matches.empty()) return;
  cv::Mat left;
  cv::Mat right;
  cv::cvtColor(pair.left.frame, left, cv::COLOR_BGR2GRAY);
  cv::cvtColor(pair.right.frame, right, cv::COLOR_BGR2GRAY);
  std::vector<cv::Point2f> from;
  std::vector<cv::Point2f> to;
  for (const Match& match : matches) {
    const double disparity = std::round(mark.disparity(camera, match.u_left, match.v_left));
    from.emplace_back(static_cast<float>(match.u_left), static_cast<float>(match.v_left));
    to.emplace_back(static_cast<float>(match.u_left - disparity), static_cast<float>(match.v_left));
  }
  std::vector<std::uint8_t> found;
  std::vector<float> unused;
  // One level: a start within half a pixel needs no pyramid.
  cv::calcOpticalFlowPyrLK(left, right, from, to, found, unused, {kFlowWindow, kFlowWindow}, 0,
                           cv::TermCriteria(cv::TermCriteria::COUNT + cv::TermCriteria::EPS, 30, 0.001),
                           cv::OPTFLOW_USE_INITIAL_FLOW);
  for (std::size_t i = 0; i < matches.size(); ++i) {
    const Match& match = matches[i];
    const double truth = mark.disparity(camera, match.u_left, match.v_left);
    const double error = static_cast<double>(from[i].x - to[i].x) - truth;
    if (found[i] == 0 || std::abs(error) > kFlowRanAway) continue;
    collected.flow_errors.push_back(error);
    collected.errors_where_flow.push_back(match.u_left - match.u_right - truth);
  }
}

MatchErrors measure(const robot::RobotDescription& robot, const std::vector<robot::MarkDescription>& marks,
                    const scenes::MarkStage& stage, double wanted_slope, const AccuracyParameters& parameters) {
  const geometry::StereoCamera& camera = robot.cameras.stereo;
  const mark_detector::MarkDetector detector(marks, {});
  const target_locator::LocatorParameters locator;
  target_locator::LocatorParameters until_settled = locator;
  until_settled.plane.verification.max_iterations = 20;
  until_settled.plane.verification.settled_px = 1e-3;
  // Rounding to whole levels is noise as well.
  const double sigma = std::sqrt(parameters.sigma * parameters.sigma + 1.0 / 12.0);
  std::mt19937 random(parameters.seed);
  cv::RNG noise(parameters.seed);
  MatchErrors result;
  Collected collected;
  constexpr int kMostMarks = 1000;  // should the locator find next to nothing
  while (static_cast<int>(collected.errors.size()) < parameters.num_matches && result.marks < kMostMarks) {
    const std::size_t which = static_cast<std::size_t>(result.marks++) % marks.size();
    // Either way round, as often.
    const double this_slope = result.marks % 2 == 0 ? wanted_slope : -wanted_slope;
    const Surface mark = place_mark(robot, marks[which], this_slope, parameters.even_print, random);
    const scenes::StagedPair pair = stage.render({mark}, mark, noise);
    mark_detector::Input input;
    input.left = scenes::view_of(pair.left.frame);
    input.right = scenes::view_of(pair.right.frame);
    input.stereo = camera;
    mark_detector::State state;
    const mark_detector::Output detected = detector.step(input, state);
    const target_locator::MarkObservation observation = scenes::observation_of(detected.marks[which], marks[which]);
    const Location location = locate_mark(observation, camera, locator);
    const target_locator::Patch& patch = observation.left.patch;
    if (location.status != target_locator::Status::kLocated || patch.frame.scale != 1.0) {
      ++result.unlocated;
      continue;
    }
    target_locator::MarkMasks masks;
    target_locator::prepare_masks(patch, masks);
    const Mask& inside = masks.inner;
    const NoiseFreeView view =
        noise_free(pair.left, patch, target_locator::texture_axis(target_locator::mark_colours(patch, masks).inside));
    for (const Match& match : location.matches) {
      const double truth = mark.disparity(camera, match.u_left, match.v_left);
      const Mask window = window_about(inside, static_cast<int>(std::lround(patch.frame.column_of(match.u_left))),
                                       static_cast<int>(std::lround(patch.frame.row_of(match.v_left))),
                                       locator.plane.verification.half_window);
      collected.errors.push_back(match.u_left - match.u_right - truth);
      collected.bounds.push_back(disparity_bound(view, window, sigma));
    }
    for (const Match& match : locate_mark(observation, camera, until_settled).matches) {
      const double truth = mark.disparity(camera, match.u_left, match.v_left);
      collected.converged_errors.push_back(match.u_left - match.u_right - truth);
    }
    const auto seen = geometry::project(camera, location.p_C);
    const double truth = mark.disparity(camera, seen->u_left, seen->v);
    collected.plane_errors.push_back(camera.disparity(*seen) + camera.cx_left - camera.cx_right - truth);
    collected.plane_bounds.push_back(
        plane_bound(view, inside, sigma, patch.frame.column_of(seen->u_left), patch.frame.row_of(seen->v)));
    add_flow(pair, location.matches, mark, camera, collected);
  }
  result.matches = static_cast<int>(collected.errors.size());
  result.mean = mean_absolute(collected.errors);
  result.p95 = p95_absolute(collected.errors);
  result.rms = rms(collected.errors);
  result.converged_rms = rms(collected.converged_errors);
  result.crlb = rms(collected.bounds);
  std::vector<double> normalised;
  for (std::size_t i = 0; i < collected.errors.size(); ++i) {
    normalised.push_back(collected.errors[i] / collected.bounds[i]);
  }
  result.normalised = rms(normalised);
  result.plane_rms = rms(collected.plane_errors);
  result.plane_crlb = rms(collected.plane_bounds);
  result.flow_matches = static_cast<int>(collected.flow_errors.size());
  result.flow_mean = mean_absolute(collected.flow_errors);
  result.flow_rms = rms(collected.flow_errors);
  result.rms_where_flow = rms(collected.errors_where_flow);
  return result;
}

}  // namespace

double Accuracy::rms_over_crlb() const {
  const auto of_case = [](const MatchErrors& errors) {
    return std::max(errors.rms, errors.converged_rms) / errors.crlb;
  };
  return std::max(of_case(fronto), of_case(slanted));
}

Accuracy measure_accuracy(const robot::RobotDescription& robot, const std::vector<robot::MarkDescription>& marks,
                          const AccuracyParameters& parameters) {
  scenes::StageParameters stage_parameters;
  stage_parameters.blur_px = parameters.blur_px;
  stage_parameters.sigma = parameters.sigma;
  stage_parameters.seed = parameters.seed;
  const scenes::MarkStage stage(robot, stage_parameters);
  return {measure(robot, marks, stage, 0.0, parameters), measure(robot, marks, stage, parameters.slant, parameters)};
}

}  // namespace markservo::bench
