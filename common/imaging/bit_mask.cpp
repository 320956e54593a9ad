#include "common/imaging/bit_mask.hpp"

#include <algorithm>

namespace markservo::imaging {
namespace {

struct Union {
  static constexpr bool kGrows = true;
  static uint64_t of(uint64_t a, uint64_t b) { return a | b; }
};
struct Intersection {
  static constexpr bool kGrows = false;
  static uint64_t of(uint64_t a, uint64_t b) { return a & b; }
};

// A square of 2 reach + 1 px by ever longer shifts, each at most one longer than all before it: then no gap is left at
// a border either, where what lies beyond is lost.
int next_step(int done, int reach) {
  return std::min({done + 1, reach - done, BitMask::kWordBits - 1});
}

// words[i] = Operation of it and the pixels `step` px left and right of it. `last` are the last word's pixels.
template <class Operation>
void spread_along(uint64_t* words, int count, int step, uint64_t last) {
  const int back = BitMask::kWordBits - step;
  uint64_t previous = 0;
  for (int i = 0; i < count; ++i) {
    const uint64_t here = words[i];
    const uint64_t next = i + 1 < count ? words[i + 1] : 0;
    words[i] = Operation::of(here, Operation::of((here << step) | (previous >> back), (here >> step) | (next << back)));
    previous = here;
  }
  words[count - 1] &= last;
}

template <class Operation>
void square(const BitMask& mask, int reach, BitMask& result) {
  const int words = mask.words_per_row();
  const int height = mask.height();
  result.reset(mask.width(), height);
  if (words == 0 || height == 0) return;
  const uint64_t last = low_bits((mask.width() - 1) % BitMask::kWordBits + 1);
  for (int v = 0; v < height; ++v) {
    if (mask.surely_empty(v)) continue;
    uint64_t* out = result.row(v);
    std::copy_n(mask.row(v), words, out);
    for (int done = 0, step = 0; done < reach; done += step) {
      step = next_step(done, reach);
      spread_along<Operation>(out, words, step, last);
    }
  }
  // In place: down the rows each takes the one `step` below, then up the rows the one `step` above, which has taken it.
  const auto combine = [&](int v, int other) {
    const bool inside = other >= 0 && other < height && !result.surely_empty(other);
    if (!inside && (result.surely_empty(v) || Operation::kGrows)) return;
    uint64_t* out = result.row(v);
    const uint64_t* in = inside ? result.row(other) : nullptr;
    for (int i = 0; i < words; ++i) out[i] = Operation::of(out[i], in != nullptr ? in[i] : 0);
  };
  for (int done = 0, step = 0; done < reach; done += step) {
    step = next_step(done, reach);
    for (int v = 0; v < height; ++v) combine(v, v + step);
    for (int v = height - 1; v >= 0; --v) combine(v, v - step);
  }
}

}  // namespace

void BitMask::reset(int width, int height) {
  if (width == width_ && height == height_) {
    for (int v = 0; v < height_; ++v) {
      if (surely_empty(v)) continue;
      std::fill_n(words_.data() + offset(v), words_per_row_, 0);
      declare_empty(v);
    }
    return;
  }
  width_ = width;
  height_ = height;
  words_per_row_ = (width + kWordBits - 1) / kWordBits;
  words_.assign(static_cast<std::size_t>(words_per_row_) * static_cast<std::size_t>(height), 0);
  used_.assign(static_cast<std::size_t>(height), 0);
}

void BitMask::set_run(int v, int begin, int end) {
  uint64_t* words = row(v);
  for (int u = begin; u < end;) {
    const int bit = u % kWordBits;
    const int n = std::min(kWordBits - bit, end - u);
    words[u / kWordBits] |= low_bits(n) << bit;
    u += n;
  }
}

int BitMask::next(int v, int u, bool wanted) const {
  const uint64_t* words = row(v);
  const uint64_t flip = wanted ? 0 : ~uint64_t{0};
  while (u < width_) {
    const uint64_t rest = (words[u / kWordBits] ^ flip) >> (u % kWordBits);
    if (rest != 0) return std::min(width_, u + __builtin_ctzll(rest));
    u += kWordBits - u % kWordBits;
  }
  return width_;
}

uint64_t BitMask::window(int u, int v) const {
  if (v < 0 || v >= height_ || u >= width_ || u <= -kWordBits) return 0;
  const uint64_t* words = row(v);
  if (u < 0) return words[0] << -u;
  const int word = u / kWordBits;
  const int bit = u % kWordBits;
  uint64_t bits = words[word] >> bit;
  if (bit > 0 && word + 1 < words_per_row_) bits |= words[word + 1] << (kWordBits - bit);
  return bits;
}

int64_t BitMask::count() const {
  int64_t n = 0;
  for (const uint64_t word : words_) n += __builtin_popcountll(word);
  return n;
}

void dilate(const BitMask& mask, int reach, BitMask& result) {
  square<Union>(mask, reach, result);
}

void erode(const BitMask& mask, int reach, BitMask& result) {
  square<Intersection>(mask, reach, result);
}

void complement(BitMask& mask) {
  const int words = mask.words_per_row();
  if (words == 0) return;
  const uint64_t last = low_bits((mask.width() - 1) % BitMask::kWordBits + 1);
  for (int v = 0; v < mask.height(); ++v) {
    uint64_t* row = mask.row(v);
    for (int i = 0; i < words; ++i) row[i] = ~row[i];
    row[words - 1] &= last;
  }
}

}  // namespace markservo::imaging
