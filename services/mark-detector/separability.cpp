#include "services/mark-detector/separability.hpp"

#include <algorithm>
#include <cmath>

namespace markservo::mark_detector {
namespace {

constexpr int kBlended = 2;          // px along the outline that are mark and background mixed
constexpr int kLeastMargin = 8;      // px
constexpr int kSamplesPerSide = 24;  // rows and columns looked at: enough for a mean, bounded for any size

// Mean and covariance of chromaticity.
struct Chromaticity {
  double n = 0.0;
  double x = 0.0;
  double y = 0.0;
  double xx = 0.0;
  double xy = 0.0;
  double yy = 0.0;

  void add(const uint8_t* p) {
    const double dx = p[2] - p[1];
    const double dy = p[1] - p[0];
    n += 1.0;
    x += dx;
    y += dy;
    xx += dx * dx;
    xy += dx * dy;
    yy += dy * dy;
  }
  void finish() {
    x /= n;
    y /= n;
    xx = xx / n - x * x;
    xy = xy / n - x * y;
    yy = yy / n - y * y;
  }
};

bool is_blended(const Region& mark, int u, int v) {
  const bool here = mark.test(u, v);
  for (int dv = -kBlended; dv <= kBlended; dv += kBlended) {
    for (int du = -kBlended; du <= kBlended; du += kBlended) {
      if (mark.test(u + du, v + dv) != here) return true;
    }
  }
  return false;
}

}  // namespace

double separability(const ImageView& image, const Region& mark) {
  const int margin_u = std::max(kLeastMargin, mark.width / 4);
  const int margin_v = std::max(kLeastMargin, mark.height / 4);
  const int left = std::max(0, mark.x - margin_u);
  const int top = std::max(0, mark.y - margin_v);
  const int right = std::min(image.width, mark.x + mark.width + margin_u);
  const int bottom = std::min(image.height, mark.y + mark.height + margin_v);
  const int step_u = std::max(1, (right - left) / kSamplesPerSide);
  const int step_v = std::max(1, (bottom - top) / kSamplesPerSide);
  Chromaticity inside;
  Chromaticity outside;
  for (int v = top; v < bottom; v += step_v) {
    for (int u = left; u < right; u += step_u) {
      if (is_blended(mark, u, v)) continue;
      (mark.test(u, v) ? inside : outside).add(image.pixel(u, v));
    }
  }
  if (inside.n == 0.0 || outside.n == 0.0) return 0.0;
  inside.finish();
  outside.finish();
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
