#include "tests/light/light_scene.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <opencv2/imgproc.hpp>
#include <random>

#include "services/mark-detector/colour/hue.hpp"
#include "services/mark-detector/picture/picture.hpp"

namespace markservo::light {
namespace {

constexpr int kWander_share = 40;  // the view moves over the scene by this part of its width along each axis
constexpr int kNoiseMargin = 64;   // px; each image takes another window of the noise
constexpr int kNumSimilar = 10;    // things of similar colours
constexpr double kHidden = 1.3;    // edge of what hides a mark, of the mark's
constexpr double kTurned = 1.15;   // box of a turned mark, of its edge
const cv::Scalar kHiding(140, 150, 160);

// How much the window's corner is off, frame by frame: a slow round of `size` whole pixels.
cv::Point wander(int index, int size) {
  const double angle = 0.07 * index;
  const double half = 0.5 * size;
  return {static_cast<int>(std::lround(half + half * std::sin(angle))),
          static_cast<int>(std::lround(half + half * std::cos(1.3 * angle)))};
}

cv::Rect square(double u, double v, double edge) {
  const int half = static_cast<int>(std::lround(0.5 * edge));
  return {static_cast<int>(std::lround(u)) - half, static_cast<int>(std::lround(v)) - half, 2 * half, 2 * half};
}

void paint(cv::Mat& image, const cv::Rect& where, const cv::Scalar& colour) {
  cv::rectangle(image, where, colour, cv::FILLED);
}

}  // namespace

mark_detector::Input Frame::input(const geometry::StereoCamera& camera) const {
  mark_detector::Input input;
  input.left = mark_detector::view_of(left);
  input.right = mark_detector::view_of(right);
  input.stereo = camera;
  return input;
}

LightScene::LightScene(const robot::CameraDescription& cameras, const std::vector<robot::MarkDescription>& marks,
                       double sigma, unsigned seed)
    : camera_(cameras.stereo), seed_(seed) {
  scenes::SceneParameters parameters;
  parameters.num_pairs = 1;
  parameters.num_layouts = 1;
  parameters.sigma = 0.0;
  parameters.seed = seed;
  bright_ = scenes::render_pairs(cameras, marks, parameters).front();
  for (std::size_t i = 0; i < marks.size(); ++i) {
    const Eigen::Vector3d& p = bright_.marks[i].centre;
    const double u = camera_.fx * p.x() / p.y();
    const double disparity = camera_.fx * camera_.baseline / p.y();
    marks_.push_back({u + camera_.cx_left, camera_.cy - camera_.fy * p.z() / p.y(), u - disparity + camera_.cx_right});
    mark_px_.push_back(static_cast<int>(std::ceil(camera_.fx * marks[i].size / p.y())));
  }
  add_similar_things(marks, seed);
  hidden_.left = bright_.left.clone();
  hidden_.right = bright_.right.clone();
  for (std::size_t i = 0; i < marks.size(); ++i) {
    paint(hidden_.left, square(marks_[i].u_left, marks_[i].v, kHidden * mark_px_[i]), kHiding);
    paint(hidden_.right, square(marks_[i].u_right, marks_[i].v, kHidden * mark_px_[i]), kHiding);
  }
  noise_.create(cameras.height + kNoiseMargin, cameras.width + kNoiseMargin);
  cv::RNG random(seed);
  random.fill(noise_, cv::RNG::NORMAL, 0.0, sigma);
}

// Squares half a mark's size of hues between the marks' intervals, some a few degrees from one, where no mark is.
void LightScene::add_similar_things(const std::vector<robot::MarkDescription>& marks, unsigned seed) {
  std::mt19937 random(seed + 1000U);
  const auto draw = [&](double low, double high) { return std::uniform_real_distribution<double>(low, high)(random); };
  constexpr double kBeside_deg = 8.0;
  for (int i = 0; i < kNumSimilar; ++i) {
    const robot::ColourInterval& interval = marks[static_cast<std::size_t>(i) % marks.size()].colour;
    const double beside = draw(kBeside_deg, 2.0 * kBeside_deg);
    const double hue = i % 2 == 0 ? interval.hue_max_deg + beside : interval.hue_min_deg - beside;
    const mark_detector::Bgr colour = mark_detector::bgr_of(hue, draw(0.6, 0.9), draw(120.0, 230.0));
    const int edge = mark_px_.front() / 2;
    for (int tries = 0; tries < 1000; ++tries) {
      const double u = draw(0.35, 0.95) * bright_.left.cols;
      const double v = draw(0.05, 0.95) * bright_.left.rows;
      const double disparity = 0.5 * camera_.fx * camera_.baseline / 0.26;
      const auto clear = [&](double column, double mark_column, const MarkPlace& mark, int mark_px) {
        return std::max(std::abs(column - mark_column), std::abs(v - mark.v)) > mark_px + edge;
      };
      bool is_free = true;
      for (std::size_t k = 0; k < marks_.size(); ++k) {
        is_free = is_free && clear(u, marks_[k].u_left, marks_[k], mark_px_[k]) &&
                  clear(u - disparity, marks_[k].u_right, marks_[k], mark_px_[k]);
      }
      if (!is_free) continue;
      const cv::Scalar bgr(colour[0], colour[1], colour[2]);
      paint(bright_.left, square(u, v, edge), bgr);
      paint(bright_.right, square(u - disparity, v, edge), bgr);
      break;
    }
  }
}

void LightScene::expose_view(const cv::Mat& view, const cv::Rect& window, const Gains& gains, cv::RNG& random,
                             cv::Mat& image) const {
  cv::Mat table(1, 256, CV_16SC3);
  for (int level = 0; level < 256; ++level) {
    for (int c = 0; c < 3; ++c) {
      table.at<cv::Vec3s>(level)[c] =
          static_cast<std::int16_t>(std::lround(gains[static_cast<std::size_t>(c)] * level));
    }
  }
  const cv::Mat noise =
      noise_(cv::Rect(random.uniform(0, kNoiseMargin), random.uniform(0, kNoiseMargin), window.width, window.height));
  image.create(window.size(), CV_8UC3);
  for (int v = 0; v < window.height; ++v) {
    const auto* from = view.ptr<cv::Vec3b>(window.y + v) + window.x;
    const auto* grain = noise.ptr<cv::Vec3s>(v);
    auto* to = image.ptr<cv::Vec3b>(v);
    const auto* levels = table.ptr<cv::Vec3s>();
    for (int u = 0; u < window.width; ++u) {
      for (int c = 0; c < 3; ++c) {
        to[u][c] = static_cast<std::uint8_t>(std::clamp(levels[from[u][c]][c] + grain[u][c], 0, 255));
      }
    }
  }
}

const Frame& LightScene::expose(const LightFrame& light, int index) {
  const scenes::StereoPair& pair = light.marks_hidden ? hidden_ : bright_;
  const int margin = pair.left.cols / kWander_share;
  const cv::Rect window(wander(index, margin), cv::Size(pair.left.cols - margin, pair.left.rows - margin));
  cv::RNG random(seed_ * 100003U + static_cast<unsigned>(index));
  expose_view(pair.left, window, light.gains, random, frame_.left);
  expose_view(pair.right, window, light.gains, random, frame_.right);
  frame_.marks.clear();
  for (std::size_t i = 0; i < marks_.size(); ++i) {
    const MarkPlace& mark = marks_[i];
    const auto whole = [&](double u) {
      const cv::Rect box = square(u, mark.v, kTurned * mark_px_[i]);
      return (box & window) == box;
    };
    const bool visible = !light.marks_hidden && whole(mark.u_left) && whole(mark.u_right);
    frame_.marks.push_back({mark.u_left - window.x, mark.v - window.y, mark.u_right - window.x, visible});
  }
  return frame_;
}

}  // namespace markservo::light
