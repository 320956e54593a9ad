#include "services/mark-detector/views/separability.hpp"

#include <algorithm>

#include "common/imaging/colour_sums.hpp"

namespace markservo::mark_detector {
namespace {

constexpr int kBlended = 2;      // px along the outline that are mark and background mixed
constexpr int kLeastMargin = 8;  // px
constexpr int kRows = 24;        // looked at: enough for a mean

using imaging::ColourSums;

// Mean and covariance of (x, y) = (R - G, G - B).
struct Chromaticity {
  double x = 0.0;
  double y = 0.0;
  double xx = 0.0;
  double xy = 0.0;
  double yy = 0.0;
};

Chromaticity chromaticity(const ColourSums& sums) {
  const auto c = [&](int a, int b) { return sums.covariance(a, b); };
  Chromaticity result;
  result.x = sums.mean(2) - sums.mean(1);
  result.y = sums.mean(1) - sums.mean(0);
  result.xx = c(2, 2) - 2.0 * c(1, 2) + c(1, 1);
  result.yy = c(1, 1) - 2.0 * c(0, 1) + c(0, 0);
  result.xy = c(1, 2) - c(0, 2) - c(1, 1) + c(0, 1);
  return result;
}

}  // namespace

int SeparabilityMeter::margin(const Shape& shape) {
  return std::max({kLeastMargin, shape.width / 4, shape.height / 4});
}

double SeparabilityMeter::measure(const ImageView& image, const Region& mark) {
  if (mark.width == 0 || mark.height == 0) return 0.0;
  imaging::erode(mark.inside, kBlended, inside_);
  imaging::dilate(mark.inside, kBlended, outside_);
  imaging::complement(outside_);
  const int row_step = std::max(1, mark.height / kRows);
  ColourSums in;
  ColourSums out;
  imaging::add_colours(image.pixel(mark.x, mark.y), image.stride, inside_, row_step, in);
  imaging::add_colours(image.pixel(mark.x, mark.y), image.stride, outside_, row_step, out);
  if (in.count == 0 || out.count == 0) return 0.0;
  const Chromaticity inside = chromaticity(in);
  const Chromaticity outside = chromaticity(out);
  const double dx = inside.x - outside.x;
  const double dy = inside.y - outside.y;
  const double distance_2 = dx * dx + dy * dy;
  if (distance_2 == 0.0) return 0.0;
  // Variances along the line between the means, times the squared distance.
  const auto along = [dx, dy](const Chromaticity& c) { return dx * dx * c.xx + 2.0 * dx * dy * c.xy + dy * dy * c.yy; };
  const double between = 0.25 * distance_2 * distance_2;
  const double within = 0.5 * (along(inside) + along(outside));
  return between / (between + std::max(0.0, within));
}

}  // namespace markservo::mark_detector
