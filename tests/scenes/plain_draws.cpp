#include "tests/scenes/plain_draws.hpp"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <opencv2/imgcodecs.hpp>
#include <random>

#include "common/geometry/plane_pose.hpp"
#include "services/mark-detector/mark_detector.hpp"
#include "tests/scenes/observation.hpp"

namespace markservo::scenes {
namespace {

constexpr double kSize = 0.025;  // m
constexpr int kWidth = 640;
constexpr int kHeight = 480;

// The robot's cameras.
geometry::StereoCamera camera() {
  return {784.0, 784.0, 319.5, 319.5, 239.5, 0.065};
}

struct Random {
  std::mt19937 engine;
  explicit Random(unsigned seed) : engine(seed) {}
  double between(double low, double high) { return std::uniform_real_distribution<double>(low, high)(engine); }
};

// A mark of a pure hue, red, green or blue, whose difference to the grey ground is as long as the contrast.
void colour(PlainMark& mark, int channel, double ground, double contrast) {
  mark.around = cv::Vec3d::all(ground);
  const double step = contrast / std::sqrt(3.0);
  for (int k = 0; k < 3; ++k) mark.colour[k] = ground + (k == channel ? step : -step);
}

robot::MarkDescription description_of(const PlainMark& mark, int channel) {
  robot::MarkDescription description;
  description.name = "plain";
  description.size = mark.size;
  if (mark.form == PlainForm::kBall) description.surface = robot::MarkSurface::kBall;
  if (mark.form == PlainForm::kDisc) description.outline = robot::MarkOutline::kDisc;
  const double hue = channel == 2 ? 0.0 : (channel == 1 ? 120.0 : 240.0);
  description.colour.hue_min_deg = std::fmod(hue + 330.0, 360.0);
  description.colour.hue_max_deg = std::fmod(hue + 30.0, 360.0);
  description.colour.saturation_min = 0.2;
  return description;
}

PlainMark draw_mark(const PlainCase& what, Random& random) {
  PlainMark mark;
  mark.form = what.form;
  mark.size = kSize;
  const geometry::StereoCamera eyes = camera();
  const double depth = eyes.fx * kSize / what.width_px;
  const double disparity = eyes.fx * eyes.baseline / depth;
  // Whole in both views, with a margin that a patch needs.
  const double room = 0.75 * what.width_px + 20.0;
  const double u = random.between(disparity + room, kWidth - room);
  const double v = random.between(room, kHeight - room);
  mark.p_C = point_at(eyes, u, v, depth);
  if (what.form == PlainForm::kBall) return mark;
  constexpr double kQuarterTurn_deg = 90.0;  // beyond it a square looks the same again
  const double direction = random.between(0.0, 2.0 * M_PI);
  const Eigen::Vector3d axis(std::cos(direction), 0.0, std::sin(direction));
  const double roll = geometry::radians(random.between(0.0, kQuarterTurn_deg));
  mark.axes =
      (Eigen::AngleAxisd(geometry::radians(what.slant_deg), axis) * Eigen::AngleAxisd(roll, Eigen::Vector3d::UnitY()))
          .toRotationMatrix();
  return mark;
}

cv::Mat frame_of(const PlainMark& mark, bool right, const PlainDrawParameters& parameters, cv::RNG& noise) {
  cv::Mat frame = expose(picture_of(mark, Eye(camera(), right), {kWidth, kHeight}), parameters.sigma, noise);
  if (parameters.jpeg_quality == 0) return frame;
  std::vector<std::uint8_t> packed;
  cv::imencode(".jpg", frame, packed, {cv::IMWRITE_JPEG_QUALITY, parameters.jpeg_quality});
  return cv::imdecode(packed, cv::IMREAD_COLOR);
}

void locate(const PlainMark& mark, const robot::MarkDescription& description, const PlainDrawParameters& parameters,
            cv::RNG& noise, PlainDraw& draw) {
  const geometry::StereoCamera eyes = camera();
  const cv::Mat left = frame_of(mark, false, parameters, noise);
  const cv::Mat right = frame_of(mark, true, parameters, noise);
  mark_detector::Input input;
  input.left = view_of(left);
  input.right = view_of(right);
  input.stereo = eyes;
  const mark_detector::MarkDetector detector({description}, {});
  mark_detector::State state;
  const mark_detector::Finding& found = detector.step(input, state).marks[0];
  draw.detected = found.seen_by_both();
  draw.location = target_locator::locate_mark(observation_of(found, description), eyes, {});
}

std::string shape_name(PlainForm form) {
  switch (form) {
    case PlainForm::kSquare:
      return "square";
    case PlainForm::kDisc:
      return "disc";
    case PlainForm::kBall:
      return "ball";
    case PlainForm::kTriangle:
      break;
  }
  return "triangle";
}

}  // namespace

std::string PlainCase::name() const {
  const std::string shape = shape_name(form);
  const std::string turned = form == PlainForm::kBall ? "" : (slant_deg > 0.0 ? ", slanted" : ", facing");
  return shape + " of " + std::to_string(std::lround(width_px)) + " px" + turned;
}

std::vector<PlainCase> plain_cases() {
  constexpr double kSlant_deg = 20.0;
  std::vector<PlainCase> cases;
  for (const PlainForm form : {PlainForm::kSquare, PlainForm::kDisc}) {
    for (const double slant_deg : {0.0, kSlant_deg}) {
      for (const double width_px : {30.0, 60.0, 100.0}) cases.push_back({form, width_px, slant_deg});
    }
  }
  for (const double width_px : {30.0, 60.0, 100.0}) cases.push_back({PlainForm::kBall, width_px, 0.0});
  return cases;
}

std::vector<PlainDraw> draw_plain_marks(const PlainCase& what, int count, unsigned seed,
                                        const PlainDrawParameters& parameters, const std::function<void()>& advance) {
  std::vector<PlainDraw> draws;
  for (int k = 0; k < count; ++k) {
    PlainDraw draw;
    draw.seed = seed + static_cast<unsigned>(k);
    Random random(draw.seed);
    PlainMark mark = draw_mark(what, random);
    draw.contrast = random.between(parameters.contrast_min, parameters.contrast_max);
    draw.blur_px = random.between(parameters.blur_min_px, parameters.blur_max_px);
    mark.blur_px = lens_blur(draw.blur_px);
    const int channel = k % 3;
    colour(mark, channel, random.between(110.0, 145.0), draw.contrast);
    cv::RNG noise(draw.seed + 1U);
    locate(mark, description_of(mark, channel), parameters, noise, draw);
    draw.least_rms = std::sqrt(least_covariance(mark, camera(), parameters.sigma).trace());
    if (draw.located()) {
      draw.error = draw.location.p_C - mark.p_C;
      draw.nees = draw.error.dot(draw.location.covariance.inverse() * draw.error);
    }
    draws.push_back(draw);
    if (advance) advance();
  }
  return draws;
}

PlainTotals totals_of(const std::vector<PlainDraw>& draws) {
  PlainTotals totals;
  double squares = 0.0;
  double least = 0.0;
  double nees = 0.0;
  for (const PlainDraw& draw : draws) {
    ++totals.drawn;
    if (!draw.located()) {
      ++totals.missed;
      continue;
    }
    totals.not_by_outline += draw.location.cue == target_locator::Cue::kOutline ? 0 : 1;
    squares += draw.error.squaredNorm();
    least += draw.least_rms * draw.least_rms;
    nees += draw.nees;
  }
  const double n = std::max(1, totals.drawn - totals.missed);
  totals.rms = std::sqrt(squares / n);
  totals.least_rms = std::sqrt(least / n);
  totals.mean_nees = nees / n;
  return totals;
}

}  // namespace markservo::scenes
