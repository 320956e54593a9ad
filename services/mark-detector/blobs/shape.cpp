#include "services/mark-detector/blobs/shape.hpp"

#include <algorithm>
#include <cstdint>
#include <limits>

namespace markservo::mark_detector {
namespace {

// Columns [left, right) of rows [top, bottom).
struct Box {
  int left = std::numeric_limits<int>::max();
  int right = 0;
  int top = std::numeric_limits<int>::max();
  int bottom = 0;
};

Box box_of(RunSpan runs) {
  Box box;
  for (const PixelRun& run : runs) {
    box.left = std::min(box.left, run.begin);
    box.right = std::max(box.right, run.end);
    box.top = std::min(box.top, run.v);
    box.bottom = std::max(box.bottom, run.v + 1);
  }
  return box;
}

// Exact sums over pixels, from the box's corner; 16384 x 16384 px stay below 2^63.
struct PixelSums {
  std::int64_t n = 0;
  std::int64_t u = 0;
  std::int64_t v = 0;
  std::int64_t uu = 0;
  std::int64_t uv = 0;
  std::int64_t vv = 0;
};

PixelSums sums_of(RunSpan runs, const Box& box) {
  const auto squares = [](std::int64_t n) { return (n - 1) * n * (2 * n - 1) / 6; };  // 0 + 1 + 4 + ... + (n - 1)^2
  PixelSums sums;
  for (const PixelRun& run : runs) {
    const std::int64_t begin = run.begin - box.left;
    const std::int64_t end = run.end - box.left;
    const std::int64_t v = run.v - box.top;
    const std::int64_t count = end - begin;
    const std::int64_t sum = (begin + end - 1) * count / 2;
    sums.n += count;
    sums.u += sum;
    sums.v += v * count;
    sums.uu += squares(end) - squares(begin);
    sums.uv += v * sum;
    sums.vv += v * v * count;
  }
  return sums;
}

}  // namespace

Shape shape_of(RunSpan runs) {
  Shape shape;
  if (runs.empty()) return shape;
  const Box box = box_of(runs);
  const PixelSums sums = sums_of(runs, box);
  const auto number = static_cast<double>(sums.n);
  const double mean_u = static_cast<double>(sums.u) / number;
  const double mean_v = static_cast<double>(sums.v) / number;
  shape.x = box.left;
  shape.y = box.top;
  shape.width = box.right - box.left;
  shape.height = box.bottom - box.top;
  shape.area = number;
  shape.u = box.left + mean_u;
  shape.v = box.top + mean_v;
  shape.m_uu = static_cast<double>(sums.uu) / number - mean_u * mean_u;
  shape.m_uv = static_cast<double>(sums.uv) / number - mean_u * mean_v;
  shape.m_vv = static_cast<double>(sums.vv) / number - mean_v * mean_v;
  return shape;
}

bool is_clipped(const Shape& shape, int image_width, int image_height) {
  return shape.x <= 0 || shape.y <= 0 || shape.x + shape.width >= image_width || shape.y + shape.height >= image_height;
}

}  // namespace markservo::mark_detector
