#include "tests/bench/baseline_at.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <opencv2/imgproc.hpp>

namespace markservo::bench {
namespace {

constexpr int kHalfWindow = 3;  // of the 7 x 7 px that are compared
constexpr int kRowReach = 2;    // px
constexpr std::size_t kFeatures = 32;
constexpr float kMinRoundness = 0.15F;
constexpr float kTraceFloor = 1.0F;  // (grey levels per px)^2

// Sum of absolute differences of both gradients over the window about (u, v) left and (x, y) right.
int difference(const cv::Mat& left_dx, const cv::Mat& left_dy, int u, int v, const cv::Mat& right_dx,
               const cv::Mat& right_dy, int x, int y) {
  int sum = 0;
  for (int j = -kHalfWindow; j <= kHalfWindow; ++j) {
    const short* const lx = left_dx.ptr<short>(v + j) + u - kHalfWindow;
    const short* const ly = left_dy.ptr<short>(v + j) + u - kHalfWindow;
    const short* const rx = right_dx.ptr<short>(y + j) + x - kHalfWindow;
    const short* const ry = right_dy.ptr<short>(y + j) + x - kHalfWindow;
    for (int i = 0; i <= 2 * kHalfWindow; ++i) sum += std::abs(lx[i] - rx[i]) + std::abs(ly[i] - ry[i]);
  }
  return sum;
}

}  // namespace

BaselineAt::BaselineAt(const std::vector<robot::MarkDescription>& marks, const geometry::StereoCamera& camera)
    : camera_(camera), marks_(marks.size()), kernel_(cv::getStructuringElement(cv::MORPH_RECT, {3, 3})) {
  for (const robot::MarkDescription& mark : marks) {
    const robot::ColourInterval& colour = mark.colour;
    const auto bounds = [&](double hue_min_deg, double hue_max_deg) {
      return Bounds{{hue_min_deg / 2.0, 255.0 * colour.saturation_min, 255.0 * colour.value_min},
                    {hue_max_deg / 2.0, 255.0 * colour.saturation_max, 255.0 * colour.value_max}};
    };
    if (colour.hue_min_deg <= colour.hue_max_deg) {
      bounds_.push_back({bounds(colour.hue_min_deg, colour.hue_max_deg)});
    } else {
      bounds_.push_back({bounds(colour.hue_min_deg, 360.0), bounds(0.0, colour.hue_max_deg)});
    }
  }
}

const std::vector<BaselineAt::Mark>& BaselineAt::run(const cv::Mat& left, const cv::Mat& right) {
  find_marks(left, &Mark::left);
  find_marks(right, &Mark::right);
  for (Mark& mark : marks_) {
    mark.matches.clear();
    const cv::Rect& box = mark.left.box;
    if (box.empty() || mark.right.box.empty()) continue;
    const int disparity = (2 * box.x + box.width - 2 * mark.right.box.x - mark.right.box.width) / 2;
    const int reach = box.width / 4;
    const cv::Rect opposite(box.x - disparity - reach, box.y - kRowReach, box.width + 2 * reach,
                            box.height + 2 * kRowReach);
    take_gradients(left, box, left_);
    take_gradients(right, opposite & cv::Rect({}, right.size()), right_);
    find_features();
    match(mark, disparity, reach);
  }
  return marks_;
}

void BaselineAt::find_marks(const cv::Mat& image, View Mark::*side) {
  cv::cvtColor(image, ycrcb_, cv::COLOR_BGR2YCrCb);
  cv::split(ycrcb_, planes_.data());
  cv::equalizeHist(planes_[0], planes_[0]);
  cv::merge(planes_.data(), planes_.size(), ycrcb_);
  cv::cvtColor(ycrcb_, equalised_, cv::COLOR_YCrCb2BGR);
  cv::cvtColor(equalised_, hsv_, cv::COLOR_BGR2HSV);
  for (std::size_t i = 0; i < marks_.size(); ++i) find_view(bounds_[i], marks_[i].*side);
}

void BaselineAt::find_view(const std::vector<Bounds>& bounds, View& view) {
  cv::inRange(hsv_, bounds.front().low, bounds.front().high, view.mask);
  for (std::size_t i = 1; i < bounds.size(); ++i) {
    cv::inRange(hsv_, bounds[i].low, bounds[i].high, wrapped_);
    cv::bitwise_or(view.mask, wrapped_, view.mask);
  }
  cv::morphologyEx(view.mask, view.mask, cv::MORPH_OPEN, kernel_);
  cv::findContours(view.mask, view.contours, cv::RETR_EXTERNAL, cv::CHAIN_APPROX_SIMPLE);
  view.box = {};
  double largest_area = 0.0;
  for (std::size_t i = 0; i < view.contours.size(); ++i) {
    const double area = cv::contourArea(view.contours[i]);
    if (area <= largest_area) continue;
    largest_area = area;
    view.largest = i;
  }
  if (largest_area <= 0.0) return;
  view.box = cv::boundingRect(view.contours[view.largest]);
  view.moments = cv::moments(view.contours[view.largest]);
}

void BaselineAt::take_gradients(const cv::Mat& image, const cv::Rect& area, Gradients& gradients) {
  gradients.area = area;
  cv::cvtColor(image(area), gradients.grey, cv::COLOR_BGR2GRAY);
  cv::Sobel(gradients.grey, gradients.dx, CV_16S, 1, 0, 3);
  cv::Sobel(gradients.grey, gradients.dy, CV_16S, 0, 1, 3);
}

void BaselineAt::find_features() {
  constexpr double kPerPx = 1.0 / 64.0;  // Sobel's sums are 8 times the slope, so products are 64 times
  cv::multiply(left_.dx, left_.dx, xx_, kPerPx, CV_32F);
  cv::multiply(left_.dx, left_.dy, xy_, kPerPx, CV_32F);
  cv::multiply(left_.dy, left_.dy, yy_, kPerPx, CV_32F);
  for (cv::Mat* const product : {&xx_, &xy_, &yy_}) cv::GaussianBlur(*product, *product, {5, 5}, 1.0);
  weight_.create(xx_.size(), CV_32F);
  for (int v = 0; v < xx_.rows; ++v) {
    const auto* const xx = xx_.ptr<float>(v);
    const auto* const xy = xy_.ptr<float>(v);
    const auto* const yy = yy_.ptr<float>(v);
    auto* const weight = weight_.ptr<float>(v);
    for (int u = 0; u < xx_.cols; ++u) {
      const float determinant = xx[u] * yy[u] - xy[u] * xy[u];
      const float trace = xx[u] + yy[u] + kTraceFloor;
      const bool round = 4.0F * determinant >= kMinRoundness * trace * trace;
      weight[u] = round ? determinant / trace : 0.0F;
    }
  }
  cv::dilate(weight_, greatest_, kernel_);
  features_.clear();
  for (int v = kHalfWindow; v < weight_.rows - kHalfWindow; ++v) {
    const auto* const weight = weight_.ptr<float>(v);
    const auto* const greatest = greatest_.ptr<float>(v);
    for (int u = kHalfWindow; u < weight_.cols - kHalfWindow; ++u) {
      if (weight[u] == greatest[u] && weight[u] > 0.0F) features_.push_back({u, v, weight[u]});
    }
  }
  const std::size_t kept = std::min(kFeatures, features_.size());
  std::partial_sort(features_.begin(), features_.begin() + static_cast<std::ptrdiff_t>(kept), features_.end(),
                    [](const Feature& a, const Feature& b) { return a.weight > b.weight; });
  features_.resize(kept);
}

void BaselineAt::match(Mark& mark, int disparity, int reach) {
  const int num_columns = 2 * reach + 1;
  best_row_.resize(static_cast<std::size_t>(num_columns));
  row_costs_.resize(best_row_.size());
  for (const Feature& feature : features_) {
    const int x_first = feature.u + left_.area.x - disparity - reach - right_.area.x;
    const int y_first = feature.v + left_.area.y - kRowReach - right_.area.y;
    if (x_first < kHalfWindow || x_first + num_columns + kHalfWindow > right_.area.width) continue;
    if (y_first < kHalfWindow || y_first + 2 * kRowReach + kHalfWindow >= right_.area.height) continue;
    int least = std::numeric_limits<int>::max();
    int at = 0;
    for (int row = 0; row <= 2 * kRowReach; ++row) {
      bool better = false;
      for (int column = 0; column < num_columns; ++column) {
        const int cost =
            difference(left_.dx, left_.dy, feature.u, feature.v, right_.dx, right_.dy, x_first + column, y_first + row);
        row_costs_[static_cast<std::size_t>(column)] = cost;
        if (cost >= least) continue;
        least = cost;
        at = column;
        better = true;
      }
      if (better) best_row_.swap(row_costs_);
    }
    if (at == 0 || at == num_columns - 1) continue;  // the minimum may lie outside
    const double before = best_row_[static_cast<std::size_t>(at) - 1];
    const double after = best_row_[static_cast<std::size_t>(at) + 1];
    const double curvature = before + after - 2.0 * least;
    const double offset = curvature > 0.0 ? 0.5 * (before - after) / curvature : 0.0;
    Match match;
    match.u_left = feature.u + left_.area.x;
    match.v = feature.v + left_.area.y;
    match.u_right = right_.area.x + x_first + at + offset;
    const auto point = geometry::triangulate(camera_, {match.u_left, match.v, match.u_right});
    if (!point) continue;
    match.p_C = *point;
    mark.matches.push_back(match);
  }
}

}  // namespace markservo::bench
