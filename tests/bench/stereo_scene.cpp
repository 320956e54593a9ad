#include "tests/bench/stereo_scene.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <future>
#include <opencv2/imgproc.hpp>
#include <random>
#include <utility>

namespace markservo::bench {
namespace {

constexpr int kSamples = 4;  // a pixel, along each axis
constexpr double kRadPerDeg = 3.14159265358979323846 / 180.0;

// A rectangle in space with a print on it.
struct Surface {
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();  // m, in C
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();
  double width = 0.0;   // m
  double height = 0.0;  // m
  cv::Vec3f colour;     // brightest
  double cell = 0.0;    // m, of the print
  double depth = 0.0;   // share of the brightness that the print varies by
  unsigned seed = 0;
};

// A scene: surfaces from far to near, with the marks among them.
struct Layout {
  std::vector<Surface> surfaces;
  std::vector<MarkTruth> marks;
};

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

cv::Vec3f colour_at(const Surface& surface, double x, double z) {
  const double a = x / surface.cell;
  const double b = z / surface.cell;
  const double print =
      0.65 * smooth_noise(a, b, surface.seed) + 0.35 * smooth_noise(2.0 * a + 7.3, 2.0 * b + 1.9, surface.seed + 17U);
  return surface.colour * static_cast<float>(1.0 - surface.depth * print);
}

// BGR of a hue (degrees), saturation and value (0 to 1).
cv::Vec3f bgr(double hue, double saturation, double value) {
  const auto channel = [&](double n) {
    const double k = std::fmod(n + hue / 60.0, 6.0);
    return static_cast<float>(255.0 * value * (1.0 - saturation * std::clamp(std::min(k, 4.0 - k), 0.0, 1.0)));
  };
  return {channel(1.0), channel(3.0), channel(5.0)};
}

cv::Vec3f mark_colour(const robot::ColourInterval& interval) {
  const double span = std::fmod(interval.hue_max_deg - interval.hue_min_deg + 360.0, 360.0);
  const double saturation = interval.saturation_min + 0.65 * (interval.saturation_max - interval.saturation_min);
  return bgr(std::fmod(interval.hue_min_deg + 0.5 * span, 360.0), saturation, 0.88);
}

// The point at `depth` that the left image shows at (u, v).
Eigen::Vector3d point_at(const geometry::StereoCamera& camera, double u, double v, double depth) {
  return {depth * (u - camera.cx_left) / camera.fx, depth, -depth * (v - camera.cy) / camera.fy};
}

// Muted books and small things of the marks' colours before the wall, all of it behind the marks.
void add_clutter(const robot::CameraDescription& cameras, const std::vector<robot::MarkDescription>& marks,
                 std::mt19937& random, Layout& layout) {
  const auto draw = [&](double low, double high) { return std::uniform_real_distribution<double>(low, high)(random); };
  const auto anywhere = [&](double depth) {
    // Left of the left image lies what only the right one shows.
    return point_at(cameras.stereo, draw(-0.3, 1.0) * cameras.width, draw(0.0, 1.0) * cameras.height, depth);
  };
  constexpr int kNumBooks = 16;
  for (int i = 0; i < kNumBooks; ++i) {
    Surface book;
    book.centre = anywhere(draw(0.31, 0.42));
    book.width = draw(0.02, 0.06);
    book.height = draw(0.08, 0.20);
    // Muted, for equalisation as OpenCV does it raises saturation in the dark.
    book.colour = bgr(draw(0.0, 360.0), draw(0.0, 0.2), draw(0.25, 0.95));
    book.cell = draw(0.002, 0.01);
    book.depth = draw(0.1, 0.7);
    book.seed = static_cast<unsigned>(random());
    layout.surfaces.push_back(book);
  }
  constexpr int kNumDistractors = 9;
  for (int i = 0; i < kNumDistractors; ++i) {
    Surface thing;
    thing.centre = anywhere(draw(0.305, 0.40));
    thing.width = draw(0.004, 0.009);
    thing.height = draw(0.004, 0.009);
    thing.colour = mark_colour(marks[static_cast<std::size_t>(i) % marks.size()].colour);
    thing.cell = 0.003;
    thing.depth = 0.3;
    thing.seed = static_cast<unsigned>(random());
    layout.surfaces.push_back(thing);
  }
  std::sort(layout.surfaces.begin(), layout.surfaces.end(),
            [](const Surface& a, const Surface& b) { return a.centre.y() > b.centre.y(); });
}

// Each mark on a light card, in rows of its own so that none hides another.
void add_marks(const robot::CameraDescription& cameras, const std::vector<robot::MarkDescription>& marks,
               std::mt19937& random, Layout& layout) {
  const auto draw = [&](double low, double high) { return std::uniform_real_distribution<double>(low, high)(random); };
  for (std::size_t i = 0; i < marks.size(); ++i) {
    const double row = (static_cast<double>(i) + 0.5) / static_cast<double>(marks.size()) * cameras.height;
    // Far enough to the right to be seen by the right camera as well, 231 px to the left at 220 mm.
    const double column = draw(0.47, 0.90) * cameras.width;
    Surface mark;
    mark.centre = point_at(cameras.stereo, column, row + draw(-10.0, 10.0), draw(0.22, 0.30));
    mark.axes = (Eigen::AngleAxisd(draw(-18.0, 18.0) * kRadPerDeg, Eigen::Vector3d::UnitZ()) *
                 Eigen::AngleAxisd(draw(-12.0, 12.0) * kRadPerDeg, Eigen::Vector3d::UnitX()) *
                 Eigen::AngleAxisd(draw(-10.0, 10.0) * kRadPerDeg, Eigen::Vector3d::UnitY()))
                    .toRotationMatrix();
    mark.width = mark.height = marks[i].size;
    mark.colour = mark_colour(marks[i].colour);
    mark.cell = 0.0022;
    mark.depth = 0.55;
    mark.seed = static_cast<unsigned>(random());
    Surface card = mark;
    card.width = card.height = 1.35 * marks[i].size;
    card.colour = bgr(40.0, 0.05, draw(0.7, 0.9));
    card.cell = 0.004;
    card.depth = 0.15;
    layout.surfaces.push_back(card);
    layout.surfaces.push_back(mark);
    layout.marks.push_back({marks[i].name, mark.centre, mark.axes.col(1)});
  }
}

Layout make_layout(const robot::CameraDescription& cameras, const std::vector<robot::MarkDescription>& marks,
                   unsigned seed) {
  std::mt19937 random(seed);
  Layout layout;
  add_clutter(cameras, marks, random, layout);
  Surface wall;
  wall.centre = {0.0, 0.45, 0.0};
  wall.width = wall.height = 2.0;
  wall.colour = bgr(30.0, 0.12, 0.7);
  wall.cell = 0.006;
  wall.depth = 0.5;
  wall.seed = static_cast<unsigned>(random());
  layout.surfaces.insert(layout.surfaces.begin(), wall);
  add_marks(cameras, marks, random, layout);
  return layout;
}

// Paints one surface over the samples of a view from `origin`.
void paint(const Surface& surface, const geometry::StereoCamera& camera, const Eigen::Vector3d& origin, double cx,
           cv::Mat3f& samples) {
  const auto image_of = [&](double value, double focal, double centre) { return focal * value + centre; };
  double u_min = 1e9;
  double u_max = -1e9;
  double v_min = 1e9;
  double v_max = -1e9;
  for (const double i : {-0.5, 0.5}) {
    for (const double j : {-0.5, 0.5}) {
      const Eigen::Vector3d corner =
          surface.centre + surface.axes * Eigen::Vector3d(i * surface.width, 0.0, j * surface.height) - origin;
      const double u = image_of(corner.x() / corner.y(), camera.fx, cx);
      const double v = image_of(-corner.z() / corner.y(), camera.fy, camera.cy);
      u_min = std::min(u_min, u);
      u_max = std::max(u_max, u);
      v_min = std::min(v_min, v);
      v_max = std::max(v_max, v);
    }
  }
  const auto sample = [](double px, int limit) {
    return std::clamp(static_cast<int>(std::floor((px + 0.5) * kSamples)), 0, limit);
  };
  const Eigen::Matrix3d to_surface = surface.axes.transpose();
  const Eigen::Vector3d start = to_surface * (origin - surface.centre);
  for (int y = sample(v_min, samples.rows); y < sample(v_max + 1.0, samples.rows); ++y) {
    for (int x = sample(u_min, samples.cols); x < sample(u_max + 1.0, samples.cols); ++x) {
      const double u = (x + 0.5) / kSamples - 0.5;
      const double v = (y + 0.5) / kSamples - 0.5;
      const Eigen::Vector3d ray = to_surface * Eigen::Vector3d((u - cx) / camera.fx, 1.0, -(v - camera.cy) / camera.fy);
      const Eigen::Vector3d hit = start - start.y() / ray.y() * ray;
      if (std::abs(hit.x()) > 0.5 * surface.width || std::abs(hit.z()) > 0.5 * surface.height) continue;
      samples(y, x) = colour_at(surface, hit.x(), hit.z());
    }
  }
}

// What one lens shows, without noise.
cv::Mat3f render_view(const Layout& layout, const robot::CameraDescription& cameras, bool right, double blur_px) {
  const geometry::StereoCamera& camera = cameras.stereo;
  cv::Mat3f samples(cameras.height * kSamples, cameras.width * kSamples, cv::Vec3f(0.0F, 0.0F, 0.0F));
  for (const Surface& surface : layout.surfaces) {
    paint(surface, camera, {right ? camera.baseline : 0.0, 0.0, 0.0}, right ? camera.cx_right : camera.cx_left,
          samples);
  }
  cv::Mat3f view;
  cv::resize(samples, view, {cameras.width, cameras.height}, 0.0, 0.0, cv::INTER_AREA);
  cv::GaussianBlur(view, view, {}, blur_px);
  return view;
}

cv::Mat expose(const cv::Mat3f& view, double sigma, cv::RNG& random) {
  cv::Mat3f noisy(view.size());
  random.fill(noisy, cv::RNG::NORMAL, 0.0, sigma);
  noisy += view;
  cv::Mat image;
  noisy.convertTo(image, CV_8UC3);
  return image;
}

}  // namespace

double MarkTruth::disparity(const geometry::StereoCamera& camera, double u, double v) const {
  const Eigen::Vector3d ray((u - camera.cx_left) / camera.fx, 1.0, -(v - camera.cy) / camera.fy);
  const double depth = outward.dot(centre) / outward.dot(ray);
  return camera.fx * camera.baseline / depth + camera.cx_left - camera.cx_right;
}

std::vector<StereoPair> render_pairs(const robot::CameraDescription& cameras,
                                     const std::vector<robot::MarkDescription>& marks,
                                     const SceneParameters& parameters) {
  std::vector<StereoPair> pairs(static_cast<std::size_t>(parameters.num_pairs));
  cv::RNG random(parameters.seed);
  for (int k = 0; k < parameters.num_layouts; ++k) {
    const Layout layout = make_layout(cameras, marks, parameters.seed + static_cast<unsigned>(k));
    auto right = std::async(std::launch::async, [&] { return render_view(layout, cameras, true, parameters.blur_px); });
    const cv::Mat3f left_view = render_view(layout, cameras, false, parameters.blur_px);
    const cv::Mat3f right_view = right.get();
    const int end = (k + 1) * parameters.num_pairs / parameters.num_layouts;
    for (int i = k * parameters.num_pairs / parameters.num_layouts; i < end; ++i) {
      StereoPair& pair = pairs[static_cast<std::size_t>(i)];
      pair.left = expose(left_view, parameters.sigma, random);
      pair.right = expose(right_view, parameters.sigma, random);
      pair.marks = layout.marks;
    }
  }
  return pairs;
}

}  // namespace markservo::bench
