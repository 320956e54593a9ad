#include "tests/unit/target-locator/synthetic_mark.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <random>

namespace markservo::target_locator::test {
namespace {

constexpr int kWidth = 640;
constexpr int kHeight = 480;
// Along each axis of a pixel. Fewer on outlines, and a side that lies along the pixels would be drawn off by up to half
// a step, alike all along it.
constexpr int kRaysOnOutline = 32;
constexpr int kRaysElsewhere = 4;
constexpr int kMargin = 8;  // image px about the box
constexpr double kPi = 3.14159265358979323846;

// A fixed pseudo-random number of [0, 1) for every lattice point.
double lattice(int x, int y, unsigned seed) {
  std::uint32_t h =
      static_cast<std::uint32_t>(x) * 374761393U + static_cast<std::uint32_t>(y) * 668265263U + seed * 2246822519U;
  h = (h ^ (h >> 13)) * 1274126177U;
  h ^= h >> 16;
  return h / 4294967296.0;
}

// Smooth noise with one cell per unit.
double smooth_noise(double x, double y, unsigned seed) {
  const double fx = std::floor(x);
  const double fy = std::floor(y);
  const auto fade = [](double t) { return t * t * (3.0 - 2.0 * t); };
  const double tx = fade(x - fx);
  const double ty = fade(y - fy);
  const int ix = static_cast<int>(fx);
  const int iy = static_cast<int>(fy);
  const double top = (1.0 - tx) * lattice(ix, iy, seed) + tx * lattice(ix + 1, iy, seed);
  const double bottom = (1.0 - tx) * lattice(ix, iy + 1, seed) + tx * lattice(ix + 1, iy + 1, seed);
  return (1.0 - ty) * top + ty * bottom;
}

Eigen::Matrix3d orientation(const Scene& scene) {
  const double to_rad = kPi / 180.0;
  return (Eigen::AngleAxisd(scene.yaw_deg * to_rad, Eigen::Vector3d::UnitZ()) *
          Eigen::AngleAxisd(scene.pitch_deg * to_rad, Eigen::Vector3d::UnitX()) *
          Eigen::AngleAxisd(scene.roll_deg * to_rad, Eigen::Vector3d::UnitY()))
      .toRotationMatrix();
}

// Where the ray of `direction` (y = 1) from `origin` meets the mark's plane: x and z in the mark's own axes, m.
Eigen::Vector3d meet_mark(const Scene& scene, const Eigen::Matrix3d& axes, const Eigen::Vector3d& origin,
                          const Eigen::Vector3d& direction) {
  const Eigen::Vector3d outward = axes.col(1);
  const double distance = outward.dot(scene.centre - origin) / outward.dot(direction);
  return axes.transpose() * (origin + distance * direction - scene.centre);
}

bool hits_mark(const Scene& scene, const Eigen::Matrix3d& axes, const Eigen::Vector3d& origin,
               const Eigen::Vector3d& direction) {
  const Eigen::Vector3d on_mark = meet_mark(scene, axes, origin, direction);
  return std::max(std::abs(on_mark.x()), std::abs(on_mark.z())) <= 0.5 * scene.size;
}

// Colour (b, g, r) along the ray of `direction` (y = 1) from `origin`.
Eigen::Vector3d trace(const Scene& scene, const Eigen::Matrix3d& axes, const Eigen::Vector3d& origin,
                      const Eigen::Vector3d& direction, unsigned texture_seed) {
  const Eigen::Vector3d on_mark = meet_mark(scene, axes, origin, direction);
  const double half = 0.5 * scene.size;
  if (std::abs(on_mark.x()) <= half && std::abs(on_mark.z()) <= half) {
    if (on_mark.x() < -half + scene.hidden_share * scene.size) return {105.0, 100.0, 95.0};
    const double a = on_mark.x() / 0.0022;
    const double b = on_mark.z() / 0.0022;
    const double noise =
        0.65 * smooth_noise(a, b, texture_seed) + 0.35 * smooth_noise(2.0 * a + 7.3, 2.0 * b + 1.9, texture_seed + 17U);
    const double brightness = 1.0 - scene.texture_depth * noise;
    return brightness * Eigen::Vector3d(45.0, 40.0, 225.0);
  }
  const double wall = scene.centre.y() + scene.wall_gap;
  const Eigen::Vector3d p = origin + (wall - origin.y()) * direction;
  const double shade = 0.8 + 0.4 * smooth_noise(p.x() / 0.006, p.z() / 0.006, scene.seed + 99U);
  return shade * Eigen::Vector3d(120.0, 135.0, 125.0);
}

RenderedView render_view(const Scene& scene, bool right, int patch_limit) {
  const geometry::StereoCamera& camera = scene.camera;
  const Eigen::Matrix3d axes = orientation(scene);
  const Eigen::Vector3d origin(right ? camera.baseline : 0.0, 0.0, 0.0);
  const double cx = right ? camera.cx_right : camera.cx_left;
  const double cy = camera.cy + (right ? scene.right_row_shift : 0.0);
  const unsigned texture_seed = scene.seed + (right && scene.other_texture_in_right ? 1000U : 0U);
  // Only what can be cut out is rendered.
  const Eigen::Vector3d towards = scene.centre - origin;
  const double mid_u = cx + camera.fx * towards.x() / towards.y();
  const double mid_v = cy - camera.fy * towards.z() / towards.y();
  const double reach = 0.75 * scene.size * camera.fx / towards.y() * 1.1 + 2.0 * kMargin + 4.0;
  const int u0 = std::clamp(static_cast<int>(mid_u - reach), 0, kWidth);
  const int u1 = std::clamp(static_cast<int>(mid_u + reach), 0, kWidth);
  const int v0 = std::clamp(static_cast<int>(mid_v - reach), 0, kHeight);
  const int v1 = std::clamp(static_cast<int>(mid_v + reach), 0, kHeight);
  RenderedView out;
  if (u1 - u0 < 8 || v1 - v0 < 8) return out;
  std::mt19937 generator(scene.seed * 2U + (right ? 1U : 0U));
  std::normal_distribution<double> noise(0.0, 1.0);
  cv::Mat3b image(v1 - v0, u1 - u0);
  for (int v = v0; v < v1; ++v) {
    for (int u = u0; u < u1; ++u) {
      const auto ray = [&](double ray_u, double ray_v) {
        return Eigen::Vector3d((ray_u - cx) / camera.fx, 1.0, -(ray_v - cy) / camera.fy);
      };
      // Where no outline crosses the pixel all is smooth, and fewer rays do.
      int corners_on_mark = 0;
      for (const double du : {-0.5, 0.5}) {
        for (const double dv : {-0.5, 0.5})
          corners_on_mark += hits_mark(scene, axes, origin, ray(u + du, v + dv)) ? 1 : 0;
      }
      const int rays = corners_on_mark % 4 == 0 && scene.hidden_share == 0.0 ? kRaysElsewhere : kRaysOnOutline;
      Eigen::Vector3d sum = Eigen::Vector3d::Zero();
      for (int j = 0; j < rays; ++j) {
        for (int i = 0; i < rays; ++i) {
          sum += trace(scene, axes, origin, ray(u + (i + 0.5) / rays - 0.5, v + (j + 0.5) / rays - 0.5), texture_seed);
        }
      }
      for (int k = 0; k < 3; ++k) {
        const double value =
            sum[k] / (rays * rays) * (right ? scene.right_gain : 1.0) + scene.noise_sigma * noise(generator);
        image(v - v0, u - u0)[k] = cv::saturate_cast<uchar>(value);
      }
    }
  }
  // Red as a detector would see it: opened, the largest blob.
  cv::Mat1b red(image.size());
  for (int y = 0; y < image.rows; ++y) {
    for (int x = 0; x < image.cols; ++x) {
      const cv::Vec3b p = image(y, x);
      red(y, x) = p[2] > 1.8 * p[1] && p[2] > 1.8 * p[0] && p[2] > 50 ? 1 : 0;
    }
  }
  cv::morphologyEx(red, red, cv::MORPH_OPEN, cv::Mat::ones(3, 3, CV_8U));
  cv::Mat1i labels;
  cv::Mat1i stats;
  cv::Mat1d centroids;
  const int count = cv::connectedComponentsWithStats(red, labels, stats, centroids, 8);
  int largest = 0;
  for (int k = 1; k < count; ++k) {
    if (largest == 0 || stats(k, cv::CC_STAT_AREA) > stats(largest, cv::CC_STAT_AREA)) largest = k;
  }
  if (largest == 0) return out;
  const cv::Rect box(stats(largest, cv::CC_STAT_LEFT), stats(largest, cv::CC_STAT_TOP),
                     stats(largest, cv::CC_STAT_WIDTH), stats(largest, cv::CC_STAT_HEIGHT));
  View& view = out.view;
  view.seen = true;
  view.x = u0 + box.x;
  view.y = v0 + box.y;
  view.width = box.width;
  view.height = box.height;
  view.clipped = view.x <= 0 || view.y <= 0 || view.x + view.width >= kWidth || view.y + view.height >= kHeight;

  cv::Rect cut(box.x - kMargin, box.y - kMargin, box.width + 2 * kMargin, box.height + 2 * kMargin);
  cut &= cv::Rect(0, 0, image.cols, image.rows);
  const int scale = (std::max(cut.width, cut.height) + patch_limit - 1) / patch_limit;
  Patch& patch = view.patch;
  patch.width = cut.width / scale;
  patch.height = cut.height / scale;
  patch.frame = {static_cast<double>(u0 + cut.x), static_cast<double>(v0 + cut.y), static_cast<double>(scale)};
  const int stride = (patch.width + 7) / 8;
  out.bgr.resize(std::size_t{3} * static_cast<std::size_t>(patch.width) * static_cast<std::size_t>(patch.height));
  out.mask.assign(static_cast<std::size_t>(stride) * static_cast<std::size_t>(patch.height), 0);
  for (int y = 0; y < patch.height; ++y) {
    for (int x = 0; x < patch.width; ++x) {
      int sum[3] = {0, 0, 0};
      int inside = 0;
      for (int j = 0; j < scale; ++j) {
        for (int i = 0; i < scale; ++i) {
          const int row = cut.y + y * scale + j;
          const int column = cut.x + x * scale + i;
          for (int k = 0; k < 3; ++k) sum[k] += image(row, column)[k];
          inside += labels(row, column) == largest ? 1 : 0;
        }
      }
      const auto at =
          3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(patch.width) + static_cast<std::size_t>(x));
      for (std::size_t k = 0; k < 3; ++k) {
        out.bgr[at + k] = static_cast<std::uint8_t>((sum[k] + scale * scale / 2) / (scale * scale));
      }
      if (2 * inside > scale * scale) {
        std::uint8_t& bits =
            out.mask[static_cast<std::size_t>(y) * static_cast<std::size_t>(stride) + static_cast<std::size_t>(x) / 8];
        bits = static_cast<std::uint8_t>(bits | (1U << (x % 8)));
      }
    }
  }
  return out;
}

}  // namespace

geometry::StereoCamera default_camera() {
  return {784.0, 784.0, 319.5, 319.5, 239.5, 0.065};
}

Eigen::Vector3d Scene::normal() const {
  return -orientation(*this).col(1);
}

MarkObservation RenderedMark::observation(Surface surface, double size) const {
  MarkObservation observation;
  observation.left = left.view;
  observation.right = right.view;
  observation.left.patch.bgr = left.bgr.data();
  observation.left.patch.mask = left.mask.data();
  observation.right.patch.bgr = right.bgr.data();
  observation.right.patch.mask = right.mask.data();
  observation.surface = surface;
  observation.size = size;
  return observation;
}

RenderedMark render(const Scene& scene, int patch_limit) {
  return {render_view(scene, false, patch_limit), render_view(scene, true, patch_limit)};
}

}  // namespace markservo::target_locator::test
