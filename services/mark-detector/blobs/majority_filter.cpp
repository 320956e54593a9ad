#include "services/mark-detector/blobs/majority_filter.hpp"

#include <algorithm>

namespace markservo::mark_detector {
namespace {

std::uint64_t majority(std::uint64_t a, std::uint64_t b, std::uint64_t c) {
  return (a & b) | (a & c) | (b & c);
}

}  // namespace

void MajorityFilter::sum_row(const BitMask& mask, int v, RowSum& sum) {
  std::fill(sum.ones.begin() + sum.begin, sum.ones.begin() + sum.end, 0);
  std::fill(sum.twos.begin() + sum.begin, sum.twos.begin() + sum.end, 0);
  sum.begin = sum.end = 0;
  if (mask.surely_empty(v)) return;
  const std::uint64_t* row = mask.row(v);
  const int words = mask.words_per_row();
  int first = 0;
  while (first < words && row[first] == 0) ++first;
  if (first == words) return;
  int last = words - 1;
  while (row[last] == 0) --last;
  const std::uint64_t last_pixel = std::uint64_t{1} << ((mask.width() - 1) % BitMask::kWordBits);
  sum.begin = std::max(0, first - 1);
  sum.end = std::min(words, last + 2);
  for (int i = sum.begin; i < sum.end; ++i) {
    const std::uint64_t centre = row[i];
    const std::uint64_t left = (centre << 1) | (i > 0 ? row[i - 1] >> 63 : centre & 1U);
    const std::uint64_t right = (centre >> 1) | (i + 1 < words ? row[i + 1] << 63 : centre & last_pixel);
    const auto k = static_cast<std::size_t>(i);
    sum.ones[k] = left ^ centre ^ right;
    sum.twos[k] = majority(left, centre, right);
  }
}

// Of each pixel of the i-th word: are 5 or more of the 9 around it set?
std::uint64_t MajorityFilter::majority_of_nine(const RowSum& above, const RowSum& here, const RowSum& below,
                                               std::size_t i) {
  const std::uint64_t one = above.ones[i] ^ here.ones[i] ^ below.ones[i];
  const std::uint64_t carry = majority(above.ones[i], here.ones[i], below.ones[i]);
  // Of four bits worth two each: are two of them set, or three?
  const std::uint64_t both_a = above.twos[i] & here.twos[i];
  const std::uint64_t odd_a = above.twos[i] ^ here.twos[i];
  const std::uint64_t both_b = below.twos[i] & carry;
  const std::uint64_t odd_b = below.twos[i] ^ carry;
  const std::uint64_t three = (both_a & (both_b | odd_b)) | (both_b & odd_a);
  const std::uint64_t two = both_a | both_b | (odd_a & odd_b);
  return three | (two & one);
}

void MajorityFilter::apply(const BitMask& mask, BitMask& result) {
  result.reset(mask.width(), mask.height());
  if (mask.width() == 0 || mask.height() == 0) return;
  for (RowSum& sum : sums_) {
    sum.ones.assign(static_cast<std::size_t>(mask.words_per_row()), 0);
    sum.twos.assign(static_cast<std::size_t>(mask.words_per_row()), 0);
    sum.begin = sum.end = 0;
  }
  const int words = mask.words_per_row();
  const std::uint64_t tail = imaging::low_bits((mask.width() - 1) % BitMask::kWordBits + 1);
  const int height = mask.height();
  int summed = -1;  // the row whose sum was made last
  for (int v = 0; v < height; ++v) {
    // Nothing comes of rows that are empty, as are those above and below them.
    if (mask.surely_empty(std::max(0, v - 1)) && mask.surely_empty(v) &&
        mask.surely_empty(std::min(v + 1, height - 1))) {
      v = std::max(v, mask.next_used(v + 1) - 2);
      continue;
    }
    for (int row = std::max(summed + 1, v - 1); row <= v; ++row) sum_row(mask, std::max(row, 0), sums_[(row + 1) % 3]);
    if (v == 0) sum_row(mask, 0, sums_[0]);
    const RowSum& above = sums_[v % 3];
    const RowSum& here = sums_[(v + 1) % 3];
    RowSum& below = sums_[(v + 2) % 3];
    sum_row(mask, std::min(v + 1, height - 1), below);
    summed = v + 1;
    int begin = words;
    int end = 0;
    for (const RowSum* sum : {&above, &here, static_cast<const RowSum*>(&below)}) {
      if (sum->begin == sum->end) continue;
      begin = std::min(begin, sum->begin);
      end = std::max(end, sum->end);
    }
    if (begin >= end) continue;
    std::uint64_t* out = result.row(v);
    std::uint64_t any = 0;
    for (int word = begin; word < end; ++word) {
      const std::uint64_t within = word + 1 == words ? tail : ~std::uint64_t{0};
      out[word] = majority_of_nine(above, here, below, static_cast<std::size_t>(word)) & within;
      any |= out[word];
    }
    if (any == 0) result.declare_empty(v);
  }
}

}  // namespace markservo::mark_detector
