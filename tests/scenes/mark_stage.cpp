#include "tests/scenes/mark_stage.hpp"

#include <Eigen/Geometry>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <random>

#include "common/geometry/plane_pose.hpp"
#include "tests/scenes/clutter.hpp"

namespace markservo::scenes {
namespace {

constexpr double kRadPerDeg = geometry::radians(1.0);
constexpr int kMargin_px = 14;  // about the mark's box: a patch's and the background that an outline is held against
constexpr int kBlurReach_px = 3;

std::vector<Surface> wall_and_books(const robot::CameraDescription& cameras, unsigned seed) {
  std::mt19937 random(seed);
  const auto draw = [&](double low, double high) { return std::uniform_real_distribution<double>(low, high)(random); };
  std::vector<Surface> surfaces{wall(seed)};
  constexpr int kNumBooks = 10;
  for (int i = 0; i < kNumBooks; ++i) {
    const Eigen::Vector3d centre =
        point_at(cameras.stereo, draw(-0.3, 1.0) * cameras.width, draw(0.0, 1.0) * cameras.height, 0.42 - 0.01 * i);
    surfaces.push_back(muted_book(centre, random));
  }
  return surfaces;
}

// Sampled num_samples x num_samples times a pixel and blurred by the lens.
cv::Mat3f blurred_samples(const std::vector<Surface>& surfaces, const Eye& eye, const cv::Rect& pixels, int num_samples,
                          double blur_px) {
  cv::Mat3f samples(pixels.height * num_samples, pixels.width * num_samples, cv::Vec3f(0.0F, 0.0F, 0.0F));
  for (const Surface& surface : surfaces) paint(surface, eye, pixels.tl(), num_samples, samples);
  cv::GaussianBlur(samples, samples, {}, blur_px * num_samples);
  return samples;
}

cv::Mat3f averaged(const cv::Mat3f& samples, const cv::Rect& part, int num_samples) {
  cv::Mat3f view;
  cv::resize(samples(part), view, {part.width / num_samples, part.height / num_samples}, 0.0, 0.0, cv::INTER_AREA);
  return view;
}

}  // namespace

Surface mark_surface(const robot::MarkDescription& mark, const Eigen::Vector3d& centre, const Eigen::Vector3d& turn_deg,
                     unsigned seed) {
  Surface surface;
  surface.centre = centre;
  surface.axes = (Eigen::AngleAxisd(turn_deg.x() * kRadPerDeg, Eigen::Vector3d::UnitZ()) *
                  Eigen::AngleAxisd(turn_deg.y() * kRadPerDeg, Eigen::Vector3d::UnitX()) *
                  Eigen::AngleAxisd(turn_deg.z() * kRadPerDeg, Eigen::Vector3d::UnitY()))
                     .toRotationMatrix();
  surface.width = surface.height = mark.size;
  surface.colour = mark_colour(mark.colour);
  surface.cell = 0.0022;
  surface.depth = 0.55;
  surface.seed = seed;
  return surface;
}

MarkStage::MarkStage(const robot::RobotDescription& robot, const StageParameters& parameters)
    : cameras_(robot.cameras), parameters_(parameters), background_(wall_and_books(robot.cameras, parameters.seed)) {
  constexpr int kWallSamples = 2;  // nothing is measured there
  cv::RNG random(parameters.seed);
  const cv::Rect all(0, 0, cameras_.width, cameras_.height);
  for (const bool right : {false, true}) {
    const cv::Mat3f samples =
        blurred_samples(background_, Eye(cameras_.stereo, right), all, kWallSamples, parameters.blur_px);
    const cv::Rect part(0, 0, samples.cols, samples.rows);
    (right ? right_wall_ : left_wall_) = expose(averaged(samples, part, kWallSamples), parameters.sigma, random);
  }
}

StagedPair MarkStage::render(const std::vector<Surface>& surfaces, const Surface& mark, cv::RNG& random) const {
  StagedPair pair;
  pair.left = render_view(surfaces, mark, false, random);
  pair.right = render_view(surfaces, mark, true, random);
  return pair;
}

StagedView MarkStage::render_view(const std::vector<Surface>& surfaces, const Surface& mark, bool right,
                                  cv::RNG& random) const {
  const Eye eye(cameras_.stereo, right);
  StagedView view;
  view.frame = (right ? right_wall_ : left_wall_).clone();
  const cv::Rect2d box = box_of(mark, eye);
  const cv::Point least(static_cast<int>(std::floor(box.x)) - kMargin_px,
                        static_cast<int>(std::floor(box.y)) - kMargin_px);
  const cv::Point most(static_cast<int>(std::ceil(box.br().x)) + kMargin_px,
                       static_cast<int>(std::ceil(box.br().y)) + kMargin_px);
  view.drawn = cv::Rect(least, most) & cv::Rect(0, 0, cameras_.width, cameras_.height);
  if (view.drawn.empty()) return view;
  const cv::Rect padded(view.drawn.x - kBlurReach_px, view.drawn.y - kBlurReach_px,
                        view.drawn.width + 2 * kBlurReach_px, view.drawn.height + 2 * kBlurReach_px);
  std::vector<Surface> all = background_;
  all.insert(all.end(), surfaces.begin(), surfaces.end());
  const int n = parameters_.num_samples;
  const cv::Mat3f samples = blurred_samples(all, eye, padded, n, parameters_.blur_px);
  const cv::Rect part(kBlurReach_px * n, kBlurReach_px * n, view.drawn.width * n, view.drawn.height * n);
  view.clean = averaged(samples, part, n);
  const cv::Mat3f ahead = averaged(samples, part + cv::Point(1, 0), n);
  const cv::Mat3f behind = averaged(samples, part - cv::Point(1, 0), n);
  view.clean_change_along_u = (ahead - behind) * (0.5F * static_cast<float>(n));
  expose(view.clean, parameters_.sigma, random).copyTo(view.frame(view.drawn));
  return view;
}

}  // namespace markservo::scenes
