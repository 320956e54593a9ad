#include "tests/scenes/learning_draws.hpp"

#include <algorithm>
#include <cmath>
#include <random>

#include "services/mark-detector/learning/colour_learning.hpp"
#include "services/mark-detector/learning/learning_check.hpp"
#include "services/mark-detector/mark_detector.hpp"
#include "tests/scenes/seen_difference.hpp"

namespace markservo::scenes {
namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr int kShift_px = 5;
constexpr double kNearHue_deg = 30.0;
constexpr double kOtherColour = 5.0;   // of seen_difference: from 1 on it is seen side by side, from 2 at a glance
constexpr unsigned kNoiseSeed = 7919;  // noise apart from the scene's numbers

class Random {
 public:
  explicit Random(unsigned seed) : engine_(seed) {}
  double between(double low, double high) { return std::uniform_real_distribution<double>(low, high)(engine_); }
  int within(int most) { return std::uniform_int_distribution<int>(-most, most)(engine_); }

 private:
  std::mt19937 engine_;
};

double overlap_with(const mark_detector::View& view, const cv::Mat& mask) {
  if (!view.seen) return 0.0;
  double both = 0.0;
  double either = 0.0;
  for (int v = 0; v < mask.rows; ++v) {
    for (int u = 0; u < mask.cols; ++u) {
      const bool found = view.region.test(u, v);
      const bool there = mask.at<std::uint8_t>(v, u) != 0;
      both += found && there ? 1.0 : 0.0;
      either += found || there ? 1.0 : 0.0;
    }
  }
  return either > 0.0 ? both / either : 0.0;
}

}  // namespace

GlossyBall draw_glossy_ball(unsigned seed) {
  Random random(seed);
  GlossyBall ball;
  ball.radius = random.between(20.0, 55.0);
  const double clear = ball.radius + 20.0;
  ball.u = random.between(clear, ball.width - clear);
  ball.v = random.between(clear, ball.height - clear);
  const double hue_deg = random.between(0.0, 360.0);
  const double saturation = random.between(0.6, 0.95);
  ball.body = mark_detector::bgr_of(hue_deg, saturation, random.between(120.0, 230.0));
  do {
    const double wall_hue_deg = hue_deg + random.between(-kNearHue_deg, kNearHue_deg);
    const double wall_saturation = saturation * random.between(0.15, 1.0);
    ball.wall = mark_detector::bgr_of(wall_hue_deg, wall_saturation, random.between(110.0, 230.0));
  } while (seen_difference(ball.body, ball.wall) < kOtherColour);
  ball.wall_slope = {random.between(-0.3, 0.3), random.between(-0.3, 0.3)};
  const double tilt = random.between(0.1, 0.9);  // rad, of the lamp from the camera
  const double around = random.between(0.0, 2.0 * kPi);
  ball.to_lamp = {std::sin(tilt) * std::cos(around), std::sin(tilt) * std::sin(around), std::cos(tilt)};
  ball.ambient = random.between(0.25, 0.45);
  for (double& gain : ball.lamp) gain = random.between(0.96, 1.04);
  ball.highlight_share = random.between(0.0, 0.1);
  ball.highlight_peak = random.between(0.6, 1.2);
  ball.highlight_sharpness = random.between(1.0, 3.0);
  return ball;
}

LearningDraw learn_from(const GlossyBall& ball, const cv::Point& shift,
                        const std::vector<robot::MarkDescription>& marks, std::size_t mark, unsigned seed) {
  LearningDraw draw;
  draw.seed = seed;
  draw.ball = ball;
  draw.shift = shift;
  const BallPicture picture = draw_ball(ball, seed + kNoiseSeed);
  draw.box = (picture.box + shift) & cv::Rect({0, 0}, picture.image.size());
  const mark_detector::ImageView view{picture.image.ptr<std::uint8_t>(), picture.image.cols, picture.image.rows,
                                      static_cast<std::ptrdiff_t>(picture.image.step[0])};
  const mark_detector::LearningPicture example{view, draw.box.x, draw.box.y, draw.box.width, draw.box.height};
  const mark_detector::LearnedColour learned = mark_detector::learn_colour({example}, {});
  draw.failure = learned.failure;
  if (!learned.failure.empty()) return draw;
  draw.learned = learned.interval;

  std::vector<robot::MarkDescription> changed = marks;
  changed.at(mark).colour = learned.interval;
  const mark_detector::MarkDetector detector(changed, {});
  draw.warning = mark_detector::doubt_about_learning(detector, mark, example, learned.mark_px2.at(0));
  if (draw.warning.empty()) draw.warning = learned.doubt;
  mark_detector::Input input;
  input.left = view;
  mark_detector::State state;
  draw.overlap = overlap_with(detector.step(input, state).marks.at(mark).left, picture.mask);
  return draw;
}

std::vector<LearningDraw> draw_learning(const std::vector<robot::MarkDescription>& marks, std::size_t mark, int count,
                                        unsigned seed, const std::function<void()>& advance) {
  std::vector<LearningDraw> draws;
  for (int i = 0; i < count; ++i) {
    const unsigned own = seed + static_cast<unsigned>(i);
    Random random(own + 2U * kNoiseSeed);
    const cv::Point shift(random.within(kShift_px), random.within(kShift_px));
    draws.push_back(learn_from(draw_glossy_ball(own), shift, marks, mark, own));
    if (advance) advance();
  }
  return draws;
}

}  // namespace markservo::scenes
