#include "tests/scenes/stereo_scene.hpp"

#include <algorithm>
#include <future>
#include <opencv2/imgproc.hpp>
#include <random>

#include "tests/scenes/clutter.hpp"
#include "tests/scenes/mark_stage.hpp"

namespace markservo::scenes {
namespace {

constexpr int kSamples = 4;  // a pixel, along each axis

// A scene: surfaces from far to near, with the marks among them.
struct Layout {
  std::vector<Surface> surfaces;
  std::vector<Surface> marks;
};

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
    layout.surfaces.push_back(muted_book(anywhere(draw(0.31, 0.42)), random));
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
    // One by one: in which order arguments are evaluated, compilers for other processors decide otherwise.
    const double depth = draw(0.22, 0.30);
    const double off_row = draw(-10.0, 10.0);
    const Eigen::Vector3d centre = point_at(cameras.stereo, column, row + off_row, depth);
    const double roll_deg = draw(-10.0, 10.0);
    const double pitch_deg = draw(-12.0, 12.0);
    const double yaw_deg = draw(-18.0, 18.0);
    const Surface mark =
        mark_surface(marks[i], centre, {yaw_deg, pitch_deg, roll_deg}, static_cast<unsigned>(random()));
    Surface card = mark;
    card.width = card.height = 1.35 * marks[i].size;
    card.colour = bgr(40.0, 0.05, draw(0.7, 0.9));
    card.cell = 0.004;
    card.depth = 0.15;
    layout.surfaces.push_back(card);
    layout.surfaces.push_back(mark);
    layout.marks.push_back(mark);
  }
}

Layout make_layout(const robot::CameraDescription& cameras, const std::vector<robot::MarkDescription>& marks,
                   unsigned seed) {
  std::mt19937 random(seed);
  Layout layout;
  add_clutter(cameras, marks, random, layout);
  layout.surfaces.insert(layout.surfaces.begin(), wall(static_cast<unsigned>(random())));
  add_marks(cameras, marks, random, layout);
  return layout;
}

// What one lens shows, without noise.
cv::Mat3f render_view(const Layout& layout, const robot::CameraDescription& cameras, bool right, double blur_px) {
  cv::Mat3f samples(cameras.height * kSamples, cameras.width * kSamples, cv::Vec3f(0.0F, 0.0F, 0.0F));
  const Eye eye(cameras.stereo, right);
  for (const Surface& surface : layout.surfaces) paint(surface, eye, {0, 0}, kSamples, samples);
  cv::Mat3f view;
  cv::resize(samples, view, {cameras.width, cameras.height}, 0.0, 0.0, cv::INTER_AREA);
  cv::GaussianBlur(view, view, {}, blur_px);
  return view;
}

}  // namespace

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

}  // namespace markservo::scenes
