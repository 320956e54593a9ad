#include "services/mark-detector/patches/patch_cutter.hpp"

#include <algorithm>
#include <cstddef>
#include <cstring>

namespace markservo::mark_detector {
namespace {

// At scale 1: the image's own pixels, the region's own bits.
void copy_patch(const ImageView& image, const Region& mark, Patch& patch) {
  const auto row_bytes = 3 * static_cast<std::size_t>(patch.width);
  const std::size_t mask_stride = (static_cast<std::size_t>(patch.width) + 7) / 8;
  for (int j = 0; j < patch.height; ++j) {
    const auto row = static_cast<std::size_t>(j);
    std::memcpy(&patch.bgr[row * row_bytes], image.pixel(patch.x, patch.y + j), row_bytes);
    for (int i = 0; i < patch.width; i += BitMask::kWordBits) {
      std::uint64_t bits = mark.inside.window(patch.x + i - mark.x, patch.y + j - mark.y);
      const int n = std::min(BitMask::kWordBits, patch.width - i);
      if (n < BitMask::kWordBits) bits &= (std::uint64_t{1} << n) - 1;
      for (int k = 0; k < n; k += 8) {
        patch.mask[row * mask_stride + static_cast<std::size_t>(i + k) / 8] = static_cast<std::uint8_t>(bits >> k);
      }
    }
  }
}

// Adds to `counts`, one a patch pixel, how many of the `scale` pixels from column `u` of row `v` on are mark, and so
// on.
void count_mark(const Region& mark, int u, int v, int scale, std::vector<std::uint32_t>& counts) {
  for (std::uint32_t& count : counts) {
    for (int i = 0; i < scale; i += BitMask::kWordBits) {
      const std::uint64_t bits = mark.inside.window(u + i - mark.x, v - mark.y);
      count += static_cast<std::uint32_t>(imaging::count_bits(bits & imaging::low_bits(scale - i)));
    }
    u += scale;
  }
}

// The same for scales of which many fit a word.
void count_mark_by_words(const Region& mark, int u, int v, int scale, std::vector<std::uint32_t>& counts) {
  const int per_word = BitMask::kWordBits / scale;
  const std::uint64_t lowest = imaging::low_bits(scale);
  for (std::size_t i = 0; i < counts.size(); i += static_cast<std::size_t>(per_word), u += per_word * scale) {
    std::uint64_t bits = mark.inside.window(u - mark.x, v - mark.y);
    const std::size_t end = std::min(counts.size(), i + static_cast<std::size_t>(per_word));
    for (std::size_t k = i; bits != 0 && k < end; ++k, bits >>= scale) {
      counts[k] += static_cast<std::uint32_t>(imaging::count_bits(bits & lowest));
    }
  }
}

// The sums of `rows` rows of bytes, from `first` on.
void sum_rows(const std::uint8_t* first, std::ptrdiff_t stride, int rows, std::vector<std::uint32_t>& sums) {
  std::uint32_t* const out = sums.data();
  const std::size_t count = sums.size();
  for (std::size_t i = 0; i < count; ++i) out[i] = first[i];
  for (int row = 1; row < rows; ++row) {
    const std::uint8_t* in = first + row * stride;
    for (std::size_t i = 0; i < count; ++i) out[i] += in[i];
  }
}

// Averages along a row of column sums, `scale` pixels to one; kScale is that, or 0 for any.
template <int kScale>
void average_row(const std::uint32_t* in, std::size_t width, int any_scale, std::uint8_t* out) {
  const int scale = kScale > 0 ? kScale : any_scale;
  const auto n = static_cast<std::uint32_t>(scale * scale);
  // Exact instead of a division as long as 255 n^2 fits 32 bits.
  constexpr std::uint32_t kLargest = 4096;
  const std::uint64_t inverse = ((std::uint64_t{1} << 32) + n - 1) / n;
  for (std::size_t i = 0; i < width; ++i, out += 3) {
    std::uint32_t sums[3] = {n / 2, n / 2, n / 2};
    for (int du = 0; du < scale; ++du, in += 3) {
      for (std::size_t c = 0; c < 3; ++c) sums[c] += in[c];
    }
    for (std::size_t c = 0; c < 3; ++c) {
      out[c] = static_cast<std::uint8_t>(n <= kLargest ? (sums[c] * inverse) >> 32 : sums[c] / n);
    }
  }
}

}  // namespace

// At a larger scale: averages, and pixels of which half or more is mark.
void PatchCutter::average(const ImageView& image, const Region& mark, Patch& patch) {
  const auto width = static_cast<std::size_t>(patch.width);
  const std::size_t mask_stride = (width + 7) / 8;
  const auto half = static_cast<std::uint32_t>((patch.scale * patch.scale + 1) / 2);
  column_sums_.resize(3 * width * static_cast<std::size_t>(patch.scale));
  mark_counts_.resize(width);
  const auto average_along = patch.scale == 2 ? average_row<2> : patch.scale == 3 ? average_row<3> : average_row<0>;
  const auto count = patch.scale <= BitMask::kWordBits / 2 ? count_mark_by_words : count_mark;
  for (int j = 0; j < patch.height; ++j) {
    const int top = patch.y + j * patch.scale;
    const auto row = static_cast<std::size_t>(j);
    sum_rows(image.pixel(patch.x, top), image.stride, patch.scale, column_sums_);
    average_along(column_sums_.data(), width, patch.scale, &patch.bgr[3 * width * row]);
    std::fill(mark_counts_.begin(), mark_counts_.end(), 0U);
    for (int v = top; v < top + patch.scale; ++v) count(mark, patch.x, v, patch.scale, mark_counts_);
    std::uint8_t* bits = &patch.mask[mask_stride * row];
    for (std::size_t i = 0; i < width; ++i) {
      bits[i / 8] = static_cast<std::uint8_t>(bits[i / 8] | (unsigned{mark_counts_[i] >= half} << (i % 8)));
    }
  }
}

void PatchCutter::cut(const ImageView& image, const Region& mark, const PatchFrame& frame, Patch& patch) {
  patch.x = frame.x;
  patch.y = frame.y;
  patch.scale = frame.scale;
  patch.width = frame.width;
  patch.height = frame.height;
  const auto width = static_cast<std::size_t>(frame.width);
  const auto height = static_cast<std::size_t>(frame.height);
  const std::size_t mask_stride = (width + 7) / 8;
  patch.bgr.resize(width * height * 3);
  patch.mask.assign(mask_stride * height, 0);
  if (frame.scale == 1) {
    copy_patch(image, mark, patch);
  } else {
    average(image, mark, patch);
  }
}

}  // namespace markservo::mark_detector
