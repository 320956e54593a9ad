#include "services/mark-detector/luma_equalisation.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>

namespace markservo::mark_detector {

void accumulate(const ImageView& image, LumaHistogram& histogram) {
  // Neighbouring pixels often have the same luma: two tables keep their increments from waiting for each other.
  std::array<int64_t, 256> other{};
  for (int v = 0; v < image.height; ++v) {
    const uint8_t* p = image.row(v);
    int u = 0;
    for (; u + 2 <= image.width; u += 2, p += 6) {
      ++histogram[static_cast<std::size_t>(luma(p[0], p[1], p[2]))];
      ++other[static_cast<std::size_t>(luma(p[3], p[4], p[5]))];
    }
    if (u < image.width) ++histogram[static_cast<std::size_t>(luma(p[0], p[1], p[2]))];
  }
  for (std::size_t i = 0; i < other.size(); ++i) histogram[i] += other[i];
}

LumaShift no_shift() {
  return LumaShift{};
}

LumaShift equalising_shift(const LumaHistogram& histogram) {
  LumaShift shift = no_shift();
  const int64_t total = std::accumulate(histogram.begin(), histogram.end(), int64_t{0});
  std::size_t darkest = 0;
  while (darkest < histogram.size() && histogram[darkest] == 0) ++darkest;
  if (darkest == histogram.size() || histogram[darkest] == total) return shift;

  // Single precision and ties to even, as OpenCV does it, for the same table to the last bit.
  const float scale = 255.0F / static_cast<float>(total - histogram[darkest]);
  int64_t sum = 0;
  for (std::size_t level = darkest; level < histogram.size(); ++level) {
    if (level > darkest) sum += histogram[level];
    const long equalised = std::clamp(std::lrint(static_cast<float>(sum) * scale), 0L, 255L);
    shift[level] = static_cast<int16_t>(equalised - static_cast<long>(level));
  }
  return shift;
}

LumaShift against_darkness(const LumaShift& shift) {
  LumaShift brightening = shift;
  for (int16_t& levels : brightening) levels = std::max<int16_t>(levels, 0);
  return brightening;
}

}  // namespace markservo::mark_detector
