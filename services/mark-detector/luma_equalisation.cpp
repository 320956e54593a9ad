#include "services/mark-detector/luma_equalisation.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>

#include "services/mark-detector/colour_kernel.hpp"

namespace markservo::mark_detector {
namespace {

// Blocks far apart are not what processors expect to be read next.
void prefetch_blocks(const ImageView& image, int v, LumaSampling sampling) {
  constexpr int kLine = 64;  // bytes
  const std::ptrdiff_t block = std::ptrdiff_t{3} * imaging::BitMask::kWordBits;
  const std::ptrdiff_t row = std::ptrdiff_t{3} * image.width;
  for (std::ptrdiff_t begin = sampling.first * block; begin < row; begin += sampling.step * block) {
    for (std::ptrdiff_t i = begin; i < std::min(row, begin + block + kLine); i += kLine) {
      __builtin_prefetch(image.row(v) + i);
    }
  }
}

}  // namespace

void accumulate(const ImageView& image, LumaHistogram& histogram, int row_step, int block_step) {
  LumaCounts counts{};
  constexpr int kAhead = 8;  // rows
  for (int i = 0; i < kAhead; ++i) {
    if (i * row_step < image.height) prefetch_blocks(image, i * row_step, {i % block_step, block_step});
  }
  int first = 0;
  for (int v = 0; v < image.height; v += row_step) {
    const int ahead = v + kAhead * row_step;
    if (ahead < image.height) prefetch_blocks(image, ahead, {(first + kAhead) % block_step, block_step});
    count_luma_row(image.row(v), image.width, {first, block_step}, counts);
    first = (first + 1) % block_step;
  }
  for (const auto& table : counts) {
    for (std::size_t i = 0; i < table.size(); ++i) histogram[i] += table[i];
  }
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
