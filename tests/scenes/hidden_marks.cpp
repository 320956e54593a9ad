#include "tests/scenes/hidden_marks.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <memory>
#include <random>
#include <stdexcept>

#include "common/geometry/plane_pose.hpp"
#include "tests/scenes/mark_stage.hpp"
#include "tests/scenes/observation.hpp"

namespace markservo::scenes {
namespace {

constexpr double kPi = 3.14159265358979323846;

class Draw {
 public:
  explicit Draw(unsigned seed) : generator_(seed) {}
  double between(double low, double high) { return std::uniform_real_distribution<double>(low, high)(generator_); }
  unsigned seed() { return static_cast<unsigned>(generator_()); }
  bool chance(double share) { return between(0.0, 1.0) < share; }

 private:
  std::mt19937 generator_;
};

// Share of the mark's area that lies behind `thing`.
double hidden_share(const Surface& mark, const Surface& thing, const Eye& eye) {
  constexpr int kPoints = 25;  // along each axis
  int hidden = 0;
  for (int i = 0; i < kPoints; ++i) {
    for (int j = 0; j < kPoints; ++j) {
      const Eigen::Vector3d place(((i + 0.5) / kPoints - 0.5) * mark.width, 0.0,
                                  ((j + 0.5) / kPoints - 0.5) * mark.height);
      const Eigen::Vector3d direction = mark.centre + mark.axes * place - eye.origin;
      if (thing.holds(thing.meet(eye.origin, direction))) ++hidden;
    }
  }
  return static_cast<double>(hidden) / (kPoints * kPoints);
}

// A hand's colour as often as another that is no mark's.
cv::Vec3f hiding_colour(Draw& draw) {
  if (draw.chance(0.5)) return bgr(draw.between(18.0, 28.0), draw.between(0.25, 0.4), draw.between(0.65, 0.9));
  return bgr(draw.between(0.0, 360.0), draw.between(0.0, 0.15), draw.between(0.2, 0.9));
}

// Of sorted values, by nearest rank; 0 when there are none.
double share_below(const std::vector<double>& sorted, double share) {
  if (sorted.empty()) return 0.0;
  const auto rank = static_cast<std::size_t>(std::ceil(share * static_cast<double>(sorted.size())));
  return sorted[std::clamp<std::size_t>(rank, 1, sorted.size()) - 1];
}

struct Scene {
  std::vector<Surface> surfaces;
  Surface mark;
};

Scene draw_scene(const robot::RobotDescription& robot, const robot::MarkDescription& mark, Draw& draw) {
  const robot::CameraDescription& cameras = robot.cameras;
  Scene scene;
  // Far enough to the right to be seen by the right camera as well, 231 px to the left at 220 mm.
  const Eigen::Vector3d centre = point_at(cameras.stereo, draw.between(0.50, 0.85) * cameras.width,
                                          draw.between(0.2, 0.8) * cameras.height, draw.between(0.22, 0.30));
  const Eigen::Vector3d turn_deg(draw.between(-18.0, 18.0), draw.between(-12.0, 12.0), draw.between(-10.0, 10.0));
  scene.mark = mark_surface(mark, centre, turn_deg, draw.seed());
  if (draw.chance(0.5)) {
    Surface card = scene.mark;
    card.width = card.height = 1.35 * mark.size;
    card.colour = bgr(40.0, 0.05, draw.between(0.7, 0.9));
    card.cell = 0.004;
    card.depth = 0.15;
    scene.surfaces.push_back(card);
  }
  scene.surfaces.push_back(scene.mark);
  return scene;
}

// Puts something before the mark so that the view that shows less of it loses `share`. False where that thing cannot.
bool hide(const robot::RobotDescription& robot, const HidingParameters& parameters, Draw& draw, Scene& scene,
          HiddenMarkDraw& result) {
  const Eye left(robot.cameras.stereo, false);
  const Eye right(robot.cameras.stereo, true);
  const double share = draw.between(parameters.share_min, parameters.share_max);
  const double depth = scene.mark.centre.y() - draw.between(parameters.gap_min, parameters.gap_max);
  const double angle = draw.between(-kPi, kPi);
  result.finger = draw.chance(0.4);
  result.edge_deg = geometry::degrees(angle);
  Surface thing;
  // Its z axis points to where it comes from, its lower end hides.
  thing.axes = Eigen::AngleAxisd(0.5 * kPi - angle, Eigen::Vector3d::UnitY()).toRotationMatrix();
  thing.width = result.finger ? draw.between(0.008, 0.016) : 0.25;
  thing.height = 0.25;
  thing.colour = hiding_colour(draw);
  thing.cell = draw.between(0.0015, 0.005);
  thing.depth = draw.between(0.05, 0.4);
  thing.seed = draw.seed();
  const double aside = result.finger ? draw.between(-0.008, 0.008) : 0.0;
  // In front of the mark as seen from between the cameras; then moved in until it hides enough in either view.
  const Eigen::Vector3d middle = 0.5 * (left.origin + right.origin);
  const Eigen::Vector3d before = middle + (scene.mark.centre - middle) * (depth / scene.mark.centre.y());
  const auto place = [&](double inwards) {
    thing.centre = before + thing.axes * Eigen::Vector3d(aside, 0.0, 0.5 * thing.height - inwards);
    result.hidden_left = hidden_share(scene.mark, thing, left);
    result.hidden_right = hidden_share(scene.mark, thing, right);
    return std::max(result.hidden_left, result.hidden_right);
  };
  double out = -0.06;
  double in = 0.06;
  if (place(in) < share) return false;
  for (int k = 0; k < 20; ++k) {
    const double half = 0.5 * (out + in);
    (place(half) < share ? out : in) = half;
  }
  // From the far side a wide thing hides more and more, but a finger may have passed through.
  if (std::abs(place(in) - share) > 0.03) return false;
  scene.surfaces.push_back(thing);
  return true;
}

}  // namespace

std::vector<HiddenMarkDraw> draw_hidden_marks(const robot::RobotDescription& robot, Hiding hiding, int count,
                                              unsigned seed, const HidingParameters& parameters,
                                              const std::function<void()>& advance) {
  std::vector<std::size_t> usable;
  for (std::size_t i = 0; i < robot.marks.size(); ++i) {
    if (robot.marks[i].surface == robot::MarkSurface::kPlane && robot.marks[i].size > 0.0) usable.push_back(i);
  }
  if (usable.empty()) throw std::invalid_argument("draw_hidden_marks: the robot has no flat mark of known size");
  constexpr int kDrawsPerWall = 128;
  StageParameters stage_parameters;
  stage_parameters.num_samples = 4;
  const mark_detector::MarkDetector detector(robot.marks, {});
  const target_locator::LocatorParameters locator;
  std::unique_ptr<MarkStage> stage;
  std::vector<HiddenMarkDraw> draws;
  for (int k = 0; k < count; ++k) {
    if (k % kDrawsPerWall == 0) {
      stage_parameters.seed = seed + static_cast<unsigned>(k);
      stage = std::make_unique<MarkStage>(robot, stage_parameters);
    }
    HiddenMarkDraw result;
    result.seed = seed + static_cast<unsigned>(k);
    Draw draw(result.seed);
    const std::size_t index = usable[result.seed % usable.size()];
    Scene scene = draw_scene(robot, robot.marks[index], draw);
    if (hiding == Hiding::kPartly) {
      while (!hide(robot, parameters, draw, scene, result)) {
      }
    }
    cv::RNG noise(draw.seed());
    const StagedPair pair = stage->render(scene.surfaces, scene.mark, noise);
    mark_detector::Input input;
    input.left = view_of(pair.left.frame);
    input.right = view_of(pair.right.frame);
    input.stereo = robot.cameras.stereo;
    mark_detector::State state;
    const mark_detector::Output output = detector.step(input, state);
    const mark_detector::Finding& found = output.marks[index];
    result.detected = found.left.seen && found.right.seen;
    result.location =
        target_locator::locate_mark(observation_of(found, robot.marks[index]), robot.cameras.stereo, locator);
    if (result.located()) {
      result.error = result.location.p_C - scene.mark.centre;
      result.mahalanobis_2 = result.error.dot(result.location.covariance.inverse() * result.error);
    }
    draws.push_back(result);
    if (advance) advance();
  }
  return draws;
}

Consistency consistency_of(const std::vector<HiddenMarkDraw>& draws) {
  Consistency consistency;
  std::vector<double> sigmas;
  std::vector<double> worst_sigmas;
  std::vector<double> errors;
  int within = 0;
  double nees = 0.0;
  for (const HiddenMarkDraw& draw : draws) {
    ++consistency.drawn;
    consistency.detected += draw.detected ? 1 : 0;
    if (!draw.located()) continue;
    ++consistency.located;
    const Eigen::Matrix3d& covariance = draw.location.covariance;
    sigmas.push_back(std::sqrt(covariance.trace() / 3.0));
    worst_sigmas.push_back(
        std::sqrt(Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(covariance).eigenvalues().maxCoeff()));
    errors.push_back(draw.error.norm());
    within += draw.mahalanobis_2 < kChiSquare99 ? 1 : 0;
    nees += draw.mahalanobis_2;
  }
  const double n = std::max(1, consistency.located);
  consistency.within = within / n;
  consistency.mean_nees = nees / n;
  for (auto* values : {&sigmas, &worst_sigmas, &errors}) std::sort(values->begin(), values->end());
  consistency.median_sigma = share_below(sigmas, 0.5);
  consistency.median_worst_sigma = share_below(worst_sigmas, 0.5);
  consistency.median_error = share_below(errors, 0.5);
  consistency.p95_error = share_below(errors, 0.95);
  return consistency;
}

}  // namespace markservo::scenes
