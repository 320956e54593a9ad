#include "services/mark-detector/adaptation/colour_measurement.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace markservo::mark_detector {
namespace {

constexpr int kClipped = 250;  // level; noise of sigma 3 brings a clipped channel down to it less than once in ten
constexpr int kBlended = 2;    // px along the outline that are mark and background mixed

// Pixels of a mark, well inside it, in both images.
class Pixels {
 public:
  void gather(const ImageView& image, const Region& mark, int per_side) {
    const int step_u = std::max(1, mark.width / per_side);
    const int step_v = std::max(1, mark.height / per_side);
    for (int v = mark.y + step_v / 2; v < mark.y + mark.height; v += step_v) {
      for (int u = mark.x + step_u / 2; u < mark.x + mark.width; u += step_u) {
        if (size_ == pixels_.size()) return;
        if (is_inside(mark, u, v)) pixels_[size_++] = image.pixel(u, v);
      }
    }
  }
  const std::uint8_t* const* begin() const { return pixels_.data(); }
  const std::uint8_t* const* end() const { return pixels_.data() + size_; }

 private:
  static bool is_inside(const Region& mark, int u, int v) {
    return mark.test(u, v) && mark.test(u - kBlended, v) && mark.test(u + kBlended, v) && mark.test(u, v - kBlended) &&
           mark.test(u, v + kBlended);
  }

  // Twice kMaxSamplesPerSide per side and image: steps are rounded down.
  std::array<const std::uint8_t*, 8UL * kMaxSamplesPerSide * kMaxSamplesPerSide> pixels_{};
  std::size_t size_ = 0;
};

ColourMeasurement measure(const Pixels& pixels) {
  ColourMeasurement result;
  Bgr sum{};
  for (const std::uint8_t* p : pixels) {
    const int brightest = std::max({p[0], p[1], p[2]});
    if (brightest >= kClipped || brightest < kDarkLevel) continue;
    for (std::size_t c = 0; c < 3; ++c) sum[c] += p[c];
    ++result.unclipped;
  }
  if (result.unclipped == 0) return result;
  // A clipped pixel's brightness shows in its channels that are not clipped.
  const double peak = std::max({sum[0], sum[1], sum[2]});
  double n = 0.0;
  double brightness = 0.0;
  double squares = 0.0;
  for (const std::uint8_t* p : pixels) {
    double level = 0.0;
    double share = 0.0;
    for (std::size_t c = 0; c < 3; ++c) {
      if (p[c] >= kClipped || sum[c] <= share * peak) continue;
      share = sum[c] / peak;
      level = p[c];
    }
    if (share <= 0.0) continue;
    n += 1.0;
    brightness += level / share;
    squares += level * level / (share * share);
  }
  brightness /= n;
  for (std::size_t c = 0; c < 3; ++c) result.mean[c] = sum[c] / peak * brightness;
  result.spread = std::sqrt(std::max(0.0, squares / n - brightness * brightness)) / brightness;
  return result;
}

}  // namespace

ColourMeasurement measure_colour(const ImageView& left, const Region& in_left, const ImageView& right,
                                 const Region& in_right, int samples_per_side) {
  Pixels pixels;
  pixels.gather(left, in_left, samples_per_side);
  pixels.gather(right, in_right, samples_per_side);
  return measure(pixels);
}

}  // namespace markservo::mark_detector
