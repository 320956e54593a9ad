#include "common/imaging/bit_mask.hpp"

#include <algorithm>
#include <cstring>

namespace markservo::imaging {
namespace {

struct Union {
  static constexpr bool kGrows = true;
  static std::uint64_t of(std::uint64_t a, std::uint64_t b) { return a | b; }
};
struct Intersection {
  static constexpr bool kGrows = false;
  static std::uint64_t of(std::uint64_t a, std::uint64_t b) { return a & b; }
};

// A square of 2 reach + 1 px by ever longer shifts, each at most one longer than all before it: then no gap is left at
// a border either, where what lies beyond is lost.
int next_step(int done, int reach) {
  return std::min({done + 1, reach - done, BitMask::kWordBits - 1});
}

// words[i] = Operation of it and the pixels `step` px left and right of it. `last` are the last word's pixels.
template <class Operation>
void spread_along(std::uint64_t* words, int count, int step, std::uint64_t last) {
  const int back = BitMask::kWordBits - step;
  std::uint64_t previous = 0;
  for (int i = 0; i < count; ++i) {
    const std::uint64_t here = words[i];
    const std::uint64_t next = i + 1 < count ? words[i + 1] : 0;
    words[i] = Operation::of(here, Operation::of((here << step) | (previous >> back), (here >> step) | (next << back)));
    previous = here;
  }
  words[count - 1] &= last;
}

// a[i] = Operation of it and a[i + step]; beyond the end nothing is set.
template <class Operation>
void combine_up(std::uint64_t* a, std::size_t count, std::size_t step) {
  const std::size_t inside = count > step ? count - step : 0;
  for (std::size_t i = 0; i < inside; ++i) a[i] = Operation::of(a[i], a[i + step]);
  if (!Operation::kGrows) std::fill(a + inside, a + count, 0);
}

// a[i] = Operation of it and a[i - step].
template <class Operation>
void combine_down(std::uint64_t* a, std::size_t count, std::size_t step) {
  for (std::size_t i = count; i > step; --i) a[i - 1] = Operation::of(a[i - 1], a[i - 1 - step]);
  if (!Operation::kGrows) std::fill(a, a + std::min(step, count), 0);
}

}  // namespace

// In place: along the rows, then down them each row takes the one `step` below, then up them the one `step` above,
// which has taken it.
template <class Operation>
void BitMask::spread(const BitMask& mask, int reach) {
  width_ = height_ = words_per_row_ = 0;
  words_ = mask.words_;
  used_ = mask.used_;
  width_ = mask.width_;
  height_ = mask.height_;
  words_per_row_ = mask.words_per_row_;
  if (words_.empty()) return;
  const std::uint64_t last = low_bits((width_ - 1) % kWordBits + 1);
  for (int done = 0, step = 0; done < reach; done += step) {
    step = next_step(done, reach);
    for (int v = 0; v < height_; ++v) {
      if (!mask.surely_empty(v)) spread_along<Operation>(words_.data() + offset(v), words_per_row_, step, last);
    }
  }
  for (int done = 0, step = 0; done < reach; done += step) {
    step = next_step(done, reach);
    const std::size_t words = static_cast<std::size_t>(step) * static_cast<std::size_t>(words_per_row_);
    combine_up<Operation>(words_.data(), words_.size(), words);
    combine_down<Operation>(words_.data(), words_.size(), words);
  }
  if (!Operation::kGrows) return;
  for (int v = 0; v < height_; ++v) {
    if (mask.surely_empty(v)) continue;
    const int end = std::min(height_, v + reach + 1);
    for (int near = std::max(0, v - reach); near < end; ++near) used_[static_cast<std::size_t>(near)] = 1;
  }
}

void BitMask::reset(int width, int height) {
  if (width == width_ && height == height_) {
    for (int v = next_used(0); v < height_; v = next_used(v + 1)) {
      std::fill_n(words_.data() + offset(v), words_per_row_, 0);
      declare_empty(v);
    }
    return;
  }
  // The size last: there may be no memory for it.
  const int words_per_row = (width + kWordBits - 1) / kWordBits;
  width_ = height_ = words_per_row_ = 0;
  words_.assign(static_cast<std::size_t>(words_per_row) * static_cast<std::size_t>(height), 0);
  used_.assign(static_cast<std::size_t>(height), 0);
  width_ = width;
  height_ = height;
  words_per_row_ = words_per_row;
}

int BitMask::next_used(int v) const {
  if (v >= height_) return height_;
  const void* found = std::memchr(used_.data() + v, 1, static_cast<std::size_t>(height_ - v));
  return found == nullptr ? height_ : static_cast<int>(static_cast<const std::uint8_t*>(found) - used_.data());
}

void BitMask::set_run(int v, int begin, int end) {
  std::uint64_t* words = row(v);
  for (int u = begin; u < end;) {
    const int bit = u % kWordBits;
    const int n = std::min(kWordBits - bit, end - u);
    words[u / kWordBits] |= low_bits(n) << bit;
    u += n;
  }
}

int BitMask::next(int v, int u, bool wanted) const {
  const std::uint64_t* words = row(v);
  const std::uint64_t flip = wanted ? 0 : ~std::uint64_t{0};
  while (u < width_) {
    const std::uint64_t rest = (words[u / kWordBits] ^ flip) >> (u % kWordBits);
    if (rest != 0) return std::min(width_, u + __builtin_ctzll(rest));
    u += kWordBits - u % kWordBits;
  }
  return width_;
}

std::uint64_t BitMask::window(int u, int v) const {
  if (v < 0 || v >= height_ || u >= width_ || u <= -kWordBits) return 0;
  const std::uint64_t* words = row(v);
  if (u < 0) return words[0] << -u;
  const int word = u / kWordBits;
  const int bit = u % kWordBits;
  std::uint64_t bits = words[word] >> bit;
  if (bit > 0 && word + 1 < words_per_row_) bits |= words[word + 1] << (kWordBits - bit);
  return bits;
}

std::int64_t BitMask::count() const {
  std::int64_t n = 0;
  for (const std::uint64_t word : words_) n += count_bits(word);
  return n;
}

void dilate(const BitMask& mask, int reach, BitMask& result) {
  result.spread<Union>(mask, reach);
}

void erode(const BitMask& mask, int reach, BitMask& result) {
  result.spread<Intersection>(mask, reach);
}

void subtract(const BitMask& mask, const BitMask& other, BitMask& result) {
  if (&result != &mask && &result != &other) result.reset(mask.width(), mask.height());
  for (int v = 0; v < mask.height(); ++v) {
    const std::uint64_t* from = mask.row(v);
    const std::uint64_t* less = other.row(v);
    std::uint64_t* words = result.row(v);
    for (int i = 0; i < mask.words_per_row(); ++i) words[i] = from[i] & ~less[i];
  }
}

void complement(BitMask& mask) {
  const int words = mask.words_per_row();
  if (words == 0) return;
  const std::uint64_t last = low_bits((mask.width() - 1) % BitMask::kWordBits + 1);
  for (int v = 0; v < mask.height(); ++v) {
    std::uint64_t* row = mask.row(v);
    for (int i = 0; i < words; ++i) row[i] = ~row[i];
    row[words - 1] &= last;
  }
}

void transpose(const BitMask& mask, BitMask& result) {
  constexpr int kBits = BitMask::kWordBits;
  result.reset(mask.height(), mask.width());
  for (int top = 0; top < mask.height(); top += kBits) {
    for (int word = 0; word < mask.words_per_row(); ++word) {
      std::uint64_t block[kBits] = {};
      std::uint64_t any = 0;
      for (int v = 0; v < std::min(kBits, mask.height() - top); ++v) any |= block[v] = mask.row(top + v)[word];
      if (any == 0) continue;
      // Swaps the off-diagonal squares of ever smaller blocks (Warren, Hacker's Delight, 7-3).
      std::uint64_t low = 0x00000000FFFFFFFF;
      for (int j = kBits / 2; j != 0; j /= 2, low ^= low << j) {
        for (int k = 0; k < kBits; k = ((k | j) + 1) & ~j) {
          const std::uint64_t swapped = ((block[k] >> j) ^ block[k + j]) & low;
          block[k] ^= swapped << j;
          block[k + j] ^= swapped;
        }
      }
      const int first = word * kBits;
      for (int u = 0; u < std::min(kBits, mask.width() - first); ++u) {
        if (block[u] != 0) result.row(first + u)[top / kBits] = block[u];
      }
    }
  }
}

}  // namespace markservo::imaging
