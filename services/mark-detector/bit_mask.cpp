#include "services/mark-detector/bit_mask.hpp"

#include <algorithm>
#include <cstring>

namespace markservo::mark_detector {
namespace {

// The sum of a pixel and its neighbours left and right, 0..3, as two bit planes.
struct RowSum {
  std::vector<uint64_t> ones;
  std::vector<uint64_t> twos;
  bool empty = true;  // all zero
};

uint64_t majority(uint64_t a, uint64_t b, uint64_t c) {
  return (a & b) | (a & c) | (b & c);
}

void sum_row(const BitMask& mask, int v, RowSum& sum) {
  if (mask.row_empty(v)) {
    if (!sum.empty) {
      std::fill(sum.ones.begin(), sum.ones.end(), 0);
      std::fill(sum.twos.begin(), sum.twos.end(), 0);
    }
    sum.empty = true;
    return;
  }
  sum.empty = false;
  const uint64_t* row = mask.row(v);
  const int last = mask.words_per_row() - 1;
  const uint64_t last_pixel = uint64_t{1} << ((mask.width() - 1) % BitMask::kWordBits);
  for (int i = 0; i <= last; ++i) {
    const uint64_t centre = row[i];
    const uint64_t left = (centre << 1) | (i > 0 ? row[i - 1] >> 63 : centre & 1U);
    const uint64_t right = (centre >> 1) | (i < last ? row[i + 1] << 63 : centre & last_pixel);
    const auto k = static_cast<std::size_t>(i);
    sum.ones[k] = left ^ centre ^ right;
    sum.twos[k] = majority(left, centre, right);
  }
}

uint64_t low_bits(int n) {
  return n >= BitMask::kWordBits ? ~uint64_t{0} : (uint64_t{1} << n) - 1;
}

}  // namespace

BitMask::BitMask(int width, int height)
    : width_(width),
      height_(height),
      words_per_row_((width + kWordBits - 1) / kWordBits),
      words_(static_cast<std::size_t>(words_per_row_) * static_cast<std::size_t>(height), 0) {}

void BitMask::set_run(int v, int begin, int end) {
  uint64_t* words = row(v);
  for (int u = begin; u < end;) {
    const int bit = u % kWordBits;
    const int n = std::min(kWordBits - bit, end - u);
    words[u / kWordBits] |= low_bits(n) << bit;
    u += n;
  }
}

bool BitMask::row_empty(int v) const {
  const uint64_t* words = row(v);
  uint64_t any = 0;
  for (int i = 0; i < words_per_row_; ++i) any |= words[i];
  return any == 0;
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

BitMask majority3(const BitMask& mask) {
  BitMask result(mask.width(), mask.height());
  if (mask.width() == 0 || mask.height() == 0) return result;
  const auto words = static_cast<std::size_t>(mask.words_per_row());
  RowSum sums[3];
  for (auto& sum : sums) {
    sum.ones.resize(words);
    sum.twos.resize(words);
  }
  const uint64_t tail = low_bits((mask.width() - 1) % BitMask::kWordBits + 1);
  sum_row(mask, 0, sums[0]);
  sum_row(mask, 0, sums[1]);
  for (int v = 0; v < mask.height(); ++v) {
    const RowSum& above = sums[v % 3];
    const RowSum& here = sums[(v + 1) % 3];
    RowSum& below = sums[(v + 2) % 3];
    sum_row(mask, std::min(v + 1, mask.height() - 1), below);
    if (above.empty && here.empty && below.empty) continue;
    uint64_t* out = result.row(v);
    for (std::size_t i = 0; i < words; ++i) {
      const uint64_t one = above.ones[i] ^ here.ones[i] ^ below.ones[i];
      const uint64_t carry = majority(above.ones[i], here.ones[i], below.ones[i]);
      // Of four bits worth two each: are two of them set, or three?
      const uint64_t both_a = above.twos[i] & here.twos[i];
      const uint64_t odd_a = above.twos[i] ^ here.twos[i];
      const uint64_t both_b = below.twos[i] & carry;
      const uint64_t odd_b = below.twos[i] ^ carry;
      const uint64_t three = (both_a & (both_b | odd_b)) | (both_b & odd_a);
      const uint64_t two = both_a | both_b | (odd_a & odd_b);
      out[i] = three | (two & one);
    }
    out[words - 1] &= tail;
  }
  return result;
}

BitMask dilate(const BitMask& mask, int reach) {
  const int words = mask.words_per_row();
  BitMask across(mask.width(), mask.height());
  BitMask result(mask.width(), mask.height());
  if (words == 0) return result;
  const uint64_t tail = low_bits((mask.width() - 1) % BitMask::kWordBits + 1);
  for (int v = 0; v < mask.height(); ++v) {
    const uint64_t* in = mask.row(v);
    uint64_t* out = across.row(v);
    for (int i = 0; i < words; ++i) {
      uint64_t bits = in[i];
      for (int k = 1; k <= reach; ++k)
        bits |= mask.window(i * BitMask::kWordBits - k, v) | mask.window(i * BitMask::kWordBits + k, v);
      out[i] = bits;
    }
    out[words - 1] &= tail;
  }
  for (int v = 0; v < mask.height(); ++v) {
    uint64_t* out = result.row(v);
    const int end = std::min(mask.height() - 1, v + reach);
    for (int from = std::max(0, v - reach); from <= end; ++from) {
      const uint64_t* in = across.row(from);
      for (int i = 0; i < words; ++i) out[i] |= in[i];
    }
  }
  return result;
}

BitMask complement(const BitMask& mask) {
  BitMask result(mask.width(), mask.height());
  const int words = mask.words_per_row();
  if (words == 0) return result;
  const uint64_t tail = low_bits((mask.width() - 1) % BitMask::kWordBits + 1);
  for (int v = 0; v < mask.height(); ++v) {
    const uint64_t* in = mask.row(v);
    uint64_t* out = result.row(v);
    for (int i = 0; i < words; ++i) out[i] = ~in[i];
    out[words - 1] &= tail;
  }
  return result;
}

}  // namespace markservo::mark_detector
