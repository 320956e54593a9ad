#include "services/mark-detector/colour/luma_equalisation.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>

#include "services/mark-detector/colour/colour_kernel.hpp"

namespace markservo::mark_detector {

void accumulate(const ImageView& image, LumaHistogram& histogram, int first_row, int row_step) {
  LumaCounts counts;
  for (int v = first_row; v < image.height; v += row_step) count_luma_row(image.row(v), image.width, counts);
  for (const auto& table : counts.tables) {
    for (std::size_t i = 0; i < table.size(); ++i) histogram[i] += table[i];
  }
}

LumaShift no_shift() {
  return LumaShift{};
}

LumaShift equalising_shift(const LumaHistogram& histogram) {
  LumaShift shift = no_shift();
  const std::int64_t total = std::accumulate(histogram.begin(), histogram.end(), std::int64_t{0});
  std::size_t darkest = 0;
  while (darkest < histogram.size() && histogram[darkest] == 0) ++darkest;
  if (darkest == histogram.size() || histogram[darkest] == total) return shift;

  // Single precision and ties to even, as OpenCV does it, for the same table to the last bit.
  const float scale = 255.0F / static_cast<float>(total - histogram[darkest]);
  std::int64_t sum = 0;
  for (std::size_t level = darkest; level < histogram.size(); ++level) {
    if (level > darkest) sum += histogram[level];
    const long equalised = std::clamp(std::lrint(static_cast<float>(sum) * scale), 0L, 255L);
    shift[level] = static_cast<std::int16_t>(equalised - static_cast<long>(level));
  }
  return shift;
}

LumaShift equalising_shift(const ImageView& left, const ImageView& right, int rows) {
  LumaHistogram histogram{};
  const int step = std::max(1, left.height / rows);
  accumulate(left, histogram, 0, step);
  if (!right.empty()) accumulate(right, histogram, step / 2, step);
  return equalising_shift(histogram);
}

LumaShift against_darkness(const LumaShift& shift) {
  LumaShift brightening = shift;
  for (std::size_t level = 0; level < shift.size(); ++level) {
    const auto most = static_cast<std::int16_t>((kGreatestLift - 1.0) * static_cast<double>(level));
    brightening[level] = std::clamp<std::int16_t>(shift[level], 0, most);
  }
  return brightening;
}

}  // namespace markservo::mark_detector
