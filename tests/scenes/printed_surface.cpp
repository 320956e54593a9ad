#include "tests/scenes/printed_surface.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace markservo::scenes {
namespace {

// A fixed pseudo-random number of [0, 1) for every lattice point.
double lattice(int x, int y, unsigned seed) {
  auto h = static_cast<std::uint32_t>(x) * 374761393U + static_cast<std::uint32_t>(y) * 668265263U + seed * 2246822519U;
  h = (h ^ (h >> 13)) * 1274126177U;
  h ^= h >> 16;
  return h / 4294967296.0;
}

// Smooth noise with one cell per unit.
double smooth_noise(double x, double y, unsigned seed) {
  const auto fade = [](double t) { return t * t * (3.0 - 2.0 * t); };
  const int ix = static_cast<int>(std::floor(x));
  const int iy = static_cast<int>(std::floor(y));
  const double tx = fade(x - ix);
  const double ty = fade(y - iy);
  const double top = (1.0 - tx) * lattice(ix, iy, seed) + tx * lattice(ix + 1, iy, seed);
  const double bottom = (1.0 - tx) * lattice(ix, iy + 1, seed) + tx * lattice(ix + 1, iy + 1, seed);
  return (1.0 - ty) * top + ty * bottom;
}

cv::Vec3f colour_at(const Surface& surface, const Eigen::Vector2d& place) {
  const double a = place.x() / surface.cell;
  const double b = place.y() / surface.cell;
  double print =
      0.65 * smooth_noise(a, b, surface.seed) + 0.35 * smooth_noise(2.0 * a + 7.3, 2.0 * b + 1.9, surface.seed + 17U);
  constexpr double kDeviation = 0.155;  // of `print` about a half
  if (surface.even) print = 0.5 * (1.0 + std::erf((print - 0.5) / (kDeviation * std::sqrt(2.0))));
  return surface.colour * static_cast<float>(1.0 - surface.depth * print);
}

}  // namespace

Eigen::Vector2d Surface::meet(const Eigen::Vector3d& origin, const Eigen::Vector3d& direction) const {
  const Eigen::Vector3d outward = axes.col(1);
  const double distance = outward.dot(centre - origin) / outward.dot(direction);
  const Eigen::Vector3d place = axes.transpose() * (origin + distance * direction - centre);
  return {place.x(), place.z()};
}

bool Surface::holds(const Eigen::Vector2d& place) const {
  return std::abs(place.x()) <= 0.5 * width && std::abs(place.y()) <= 0.5 * height;
}

double Surface::disparity(const geometry::StereoCamera& camera, double u, double v) const {
  const Eigen::Vector3d outward = axes.col(1);
  const Eigen::Vector3d ray((u - camera.cx_left) / camera.fx, 1.0, -(v - camera.cy) / camera.fy);
  const double ahead = outward.dot(centre) / outward.dot(ray);
  return camera.fx * camera.baseline / ahead + camera.cx_left - camera.cx_right;
}

cv::Vec3f bgr(double hue_deg, double saturation, double value) {
  const auto channel = [&](double n) {
    const double k = std::fmod(n + hue_deg / 60.0, 6.0);
    return static_cast<float>(255.0 * value * (1.0 - saturation * std::clamp(std::min(k, 4.0 - k), 0.0, 1.0)));
  };
  return {channel(1.0), channel(3.0), channel(5.0)};
}

cv::Vec3f mark_colour(const robot::ColourInterval& interval) {
  const double span = std::fmod(interval.hue_max_deg - interval.hue_min_deg + 360.0, 360.0);
  const double saturation = interval.saturation_min + 0.65 * (interval.saturation_max - interval.saturation_min);
  return bgr(std::fmod(interval.hue_min_deg + 0.5 * span, 360.0), saturation, 0.88);
}

Eigen::Vector3d point_at(const geometry::StereoCamera& camera, double u, double v, double depth) {
  return {depth * (u - camera.cx_left) / camera.fx, depth, -depth * (v - camera.cy) / camera.fy};
}

Eye::Eye(const geometry::StereoCamera& camera, bool right)
    : origin(right ? camera.baseline : 0.0, 0.0, 0.0),
      fx(camera.fx),
      fy(camera.fy),
      cx(right ? camera.cx_right : camera.cx_left),
      cy(camera.cy) {}

cv::Point2d Eye::image_of(const Eigen::Vector3d& p_C) const {
  const Eigen::Vector3d off = p_C - origin;
  return {fx * off.x() / off.y() + cx, -fy * off.z() / off.y() + cy};
}

cv::Rect2d box_of(const Surface& surface, const Eye& eye) {
  cv::Point2d least(1e9, 1e9);
  cv::Point2d most(-1e9, -1e9);
  for (const double i : {-0.5, 0.5}) {
    for (const double j : {-0.5, 0.5}) {
      const cv::Point2d corner =
          eye.image_of(surface.centre + surface.axes * Eigen::Vector3d(i * surface.width, 0.0, j * surface.height));
      least = {std::min(least.x, corner.x), std::min(least.y, corner.y)};
      most = {std::max(most.x, corner.x), std::max(most.y, corner.y)};
    }
  }
  return {least, most};
}

void paint(const Surface& surface, const Eye& eye, const cv::Point& corner, int num_samples, cv::Mat3f& samples) {
  const cv::Rect2d box = box_of(surface, eye);
  const auto sample = [num_samples](double px, int limit) {
    return std::clamp(static_cast<int>(std::floor((px + 0.5) * num_samples)), 0, limit);
  };
  const int x_begin = sample(box.x - corner.x, samples.cols);
  const int x_end = sample(box.x - corner.x + box.width + 1.0, samples.cols);
  const int y_end = sample(box.y - corner.y + box.height + 1.0, samples.rows);
  for (int y = sample(box.y - corner.y, samples.rows); y < y_end; ++y) {
    for (int x = x_begin; x < x_end; ++x) {
      const double u = corner.x + (x + 0.5) / num_samples - 0.5;
      const double v = corner.y + (y + 0.5) / num_samples - 0.5;
      const Eigen::Vector2d place = surface.meet(eye.origin, eye.direction(u, v));
      if (surface.holds(place)) samples(y, x) = colour_at(surface, place);
    }
  }
}

cv::Mat expose(const cv::Mat3f& view, double sigma, cv::RNG& random) {
  cv::Mat3f noisy(view.size());
  random.fill(noisy, cv::RNG::NORMAL, 0.0, sigma);
  noisy += view;
  cv::Mat image;
  noisy.convertTo(image, CV_8UC3);
  return image;
}

}  // namespace markservo::scenes
