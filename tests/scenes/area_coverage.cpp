#include "tests/scenes/area_coverage.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <opencv2/imgproc.hpp>
#include <utility>

namespace markservo::scenes {
namespace {

constexpr int kFine = 4;        // cells a pixel, along each axis: what the blur is made of
constexpr double kReach = 4.0;  // sigmas of the blur, beyond which nothing shows
constexpr double kUsualBlur_px = 1.2;

// A part of an edge within one row of cells, `rise` of a cell high, covers what lies right of it: adds that as changes
// from cell to cell.
void add_within_row(float* changes, double x_begin, double x_end, double rise) {
  const auto [low, high] = std::minmax(x_begin, x_end);
  const int first = static_cast<int>(std::floor(low));
  const int last = std::max(first, static_cast<int>(std::ceil(high)) - 1);
  double passed = 0.0;  // share of the part that lies left of the cell, which it therefore covers whole
  double before = 0.0;  // covered of the cell before
  for (int cell = first; cell <= last; ++cell) {
    const double from = std::max(low, static_cast<double>(cell));
    const double to = std::min(high, cell + 1.0);
    const double share = high > low ? (to - from) / (high - low) : 1.0;
    const double covered = rise * (passed + share * (cell + 1.0 - 0.5 * (from + to)));
    changes[cell] += static_cast<float>(covered - before);
    passed += share;
    before = covered;
  }
  changes[last + 1] += static_cast<float>(rise - before);
}

// An edge in cells; rows outside are left out, columns held inside.
void add_edge(cv::Point2d from, cv::Point2d to, cv::Mat1f& cells) {
  if (from.y == to.y) return;
  double sign = 1.0;
  if (from.y > to.y) {
    std::swap(from, to);
    sign = -1.0;
  }
  const double slope = (to.x - from.x) / (to.y - from.y);
  const int first = std::max(0, static_cast<int>(std::floor(from.y)));
  const int last = std::min(cells.rows - 1, static_cast<int>(std::ceil(to.y)) - 1);
  const double most = cells.cols - 3.0;
  for (int row = first; row <= last; ++row) {
    const double top = std::max(from.y, static_cast<double>(row));
    const double bottom = std::min(to.y, row + 1.0);
    const auto column = [&](double y) { return std::clamp(from.x + slope * (y - from.y), 0.0, most); };
    add_within_row(cells[row], column(top), column(bottom), sign * (bottom - top));
  }
}

}  // namespace

cv::Mat1f blurred_coverage(const std::vector<cv::Point2d>& polygon, const cv::Rect& pixels, double blur_px) {
  // The same for all usual lenses, so that a blur can be compared with a slightly larger one.
  const double reach_px = kReach * std::max(blur_px, kUsualBlur_px);
  const int pad = static_cast<int>(std::ceil(reach_px)) + 1;
  cv::Mat1f cells(kFine * (pixels.height + 2 * pad), kFine * (pixels.width + 2 * pad), 0.0F);
  const auto cell_of = [&](const cv::Point2d& p) {
    return cv::Point2d(kFine * (p.x + 0.5 - pixels.x + pad), kFine * (p.y + 0.5 - pixels.y + pad));
  };
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    add_edge(cell_of(polygon[k]), cell_of(polygon[(k + 1) % polygon.size()]), cells);
  }
  for (int y = 0; y < cells.rows; ++y) {
    float* row = cells[y];
    float sum = 0.0F;
    for (int x = 0; x < cells.cols; ++x) {
      sum += row[x];
      row[x] = std::abs(sum);
    }
  }
  const int taps = 2 * static_cast<int>(std::ceil(reach_px * kFine)) + 1;
  cv::GaussianBlur(cells, cells, {taps, taps}, blur_px * kFine, blur_px * kFine, cv::BORDER_REPLICATE);
  cv::Mat1f coverage;
  const cv::Mat part = cells(cv::Rect(kFine * pad, kFine * pad, kFine * pixels.width, kFine * pixels.height));
  cv::resize(part, coverage, pixels.size(), 0.0, 0.0, cv::INTER_AREA);
  return coverage;
}

}  // namespace markservo::scenes
