#include "services/mark-detector/search/colour_scan.hpp"

#include <algorithm>

namespace markservo::mark_detector {
namespace {

constexpr int kWord = imaging::BitMask::kWordBits;

// Classifies the columns of a row; which rules were met. Rows that hold nothing are declared empty.
std::uint32_t scan_row(const ImageView& image, int v, int left, int right, const LumaShift& shift,
                       const ScanRules& rules) {
  std::array<std::uint64_t*, robot::kMaxMarks> words{};
  std::array<bool, robot::kMaxMarks> empty{};
  for (std::size_t k = 0; k < rules.count; ++k) {
    empty[k] = rules.masks[k]->surely_empty(v);
    words[k] = rules.masks[k]->row(v) + left / kWord;
  }
  const std::uint32_t met =
      classify_row(image.pixel(left, v), right - left, rules.rules.data(), rules.count, shift, words.data());
  for (std::size_t k = 0; k < rules.count; ++k) {
    if (((met >> k) & 1U) == 0 && empty[k]) rules.masks[k]->declare_empty(v);
  }
  return met;
}

// Row v of the window into the cache.
void prefetch(const ImageView& image, const ScanWindow& window, int v) {
  constexpr int kLine = 64;  // bytes
  for (const std::uint8_t* p = image.pixel(window.left, v); p < image.pixel(window.right, v); p += kLine) {
    __builtin_prefetch(p);
  }
}

}  // namespace

ScanWindow whole_image(const ImageView& image) {
  return {0, image.width, 0, image.height};
}

ScanWindow window_around(const Shape& shape, int margin, const ImageView& image) {
  ScanWindow window;
  window.left = std::clamp(shape.x - margin, 0, image.width - 1) / kWord * kWord;
  window.right =
      std::min(image.width, (std::max(shape.x + shape.width + margin, window.left + 1) + kWord - 1) / kWord * kWord);
  window.top = std::clamp(shape.y - margin, 0, image.height - 1);
  window.bottom = std::clamp(shape.y + shape.height + margin, window.top + 1, image.height);
  return window;
}

bool reaches_out(const Shape& shape, const ScanWindow& window, const ImageView& image) {
  // What is cleaned of noise may end a pixel before what it was made of.
  return (shape.x <= window.left + 1 && window.left > 0) || (shape.y <= window.top + 1 && window.top > 0) ||
         (shape.x + shape.width >= window.right - 1 && window.right < image.width) ||
         (shape.y + shape.height >= window.bottom - 1 && window.bottom < image.height);
}

void scan(const ImageView& image, const ScanWindow& window, const LumaShift& shift, const ScanRules& rules) {
  // Parts of rows are not what processors expect to be read next.
  constexpr int kAhead = 4;  // rows
  const bool parts = window.left > 0 || window.right < image.width;
  for (int v = window.top; parts && v < std::min(window.bottom, window.top + kAhead); ++v) prefetch(image, window, v);
  for (int v = window.top; v < window.bottom; ++v) {
    if (parts && v + kAhead < window.bottom) prefetch(image, window, v + kAhead);
    scan_row(image, v, window.left, window.right, shift, rules);
  }
}

std::uint32_t scan_rows(const ImageView& image, int first_row, int row_step, int least, const LumaShift& shift,
                        const ScanRules& rules) {
  std::uint32_t found = 0;
  for (int v = first_row; v < image.height; v += row_step) {
    const std::uint32_t met = scan_row(image, v, 0, image.width, shift, rules);
    for (std::size_t k = 0; k < rules.count; ++k) {
      if (((met >> k) & 1U) == 0) continue;
      std::uint64_t* words = rules.masks[k]->row(v);
      int count = 0;
      for (int i = 0; i < rules.masks[k]->words_per_row(); ++i) {
        count += imaging::count_bits(words[i]);
        words[i] = 0;
      }
      rules.masks[k]->declare_empty(v);
      if (count >= least) found |= std::uint32_t{1} << k;
    }
  }
  return found;
}

}  // namespace markservo::mark_detector
