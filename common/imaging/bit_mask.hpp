#pragma once

// One bit a pixel, rows padded to whole 64-bit words, lowest bit first; the padding is zero.

#include <cstddef>
#include <cstdint>
#include <vector>

namespace markservo::imaging {

class BitMask;
void dilate(const BitMask& mask, int reach, BitMask& result);
void erode(const BitMask& mask, int reach, BitMask& result);

class BitMask {
 public:
  static constexpr int kWordBits = 64;

  BitMask() = default;
  // A mask with all pixels clear. Sizes of 0 or more.
  BitMask(int width, int height) { reset(width, height); }
  // Clears all pixels and takes that size; memory is kept, and only rows in use are cleared when the size is the same.
  void reset(int width, int height);

  int width() const { return width_; }
  int height() const { return height_; }
  int words_per_row() const { return words_per_row_; }

  // From here on the row counts as in use, until it is declared empty.
  std::uint64_t* row(int v) {
    used_[static_cast<std::size_t>(v)] = 1;
    return words_.data() + offset(v);
  }
  const std::uint64_t* row(int v) const { return words_.data() + offset(v); }
  // What was written to row v is all clear.
  void declare_empty(int v) { used_[static_cast<std::size_t>(v)] = 0; }
  // True only if nothing is set in row v; a row that was written may be empty all the same.
  bool surely_empty(int v) const { return used_[static_cast<std::size_t>(v)] == 0; }

  bool test(int u, int v) const { return (row(v)[u / kWordBits] >> (u % kWordBits)) & 1U; }
  void set(int u, int v, bool value) {
    const std::uint64_t bit = std::uint64_t{1} << (u % kWordBits);
    std::uint64_t& word = row(v)[u / kWordBits];
    word = value ? word | bit : word & ~bit;
  }
  // Sets the pixels [begin, end) of row v.
  void set_run(int v, int begin, int end);

  // First pixel at or after `u` in row v whose bit is `wanted`, or the width.
  int next(int v, int u, bool wanted) const;
  // The 64 pixels of row v from column u on, lowest bit first; zero beyond the mask, on every side.
  std::uint64_t window(int u, int v) const;

  // Number of set pixels.
  std::int64_t count() const;

  bool operator==(const BitMask& other) const {
    return width_ == other.width_ && height_ == other.height_ && words_ == other.words_;
  }

  // First row at or after `v` that is in use, or the height.
  int next_used(int v) const;

 private:
  friend void dilate(const BitMask& mask, int reach, BitMask& result);
  friend void erode(const BitMask& mask, int reach, BitMask& result);

  template <class Operation>
  void spread(const BitMask& mask, int reach);

  std::size_t offset(int v) const { return static_cast<std::size_t>(v) * static_cast<std::size_t>(words_per_row_); }

  int width_ = 0;
  int height_ = 0;
  int words_per_row_ = 0;
  std::vector<std::uint64_t> words_;
  std::vector<std::uint8_t> used_;  // of each row
};

// How many bits are set; without the instruction for it, which not every processor has (Warren, Hacker's Delight, 5-1).
inline int count_bits(std::uint64_t bits) {
  bits -= (bits >> 1) & 0x5555555555555555U;
  bits = (bits & 0x3333333333333333U) + ((bits >> 2) & 0x3333333333333333U);
  bits = (bits + (bits >> 4)) & 0x0F0F0F0F0F0F0F0FU;
  return static_cast<int>((bits * 0x0101010101010101U) >> 56);
}

// The lowest n bits, 0 or more; all from 64 on.
inline std::uint64_t low_bits(int n) {
  return n >= BitMask::kWordBits ? ~std::uint64_t{0} : (std::uint64_t{1} << n) - 1;
}

// Every pixel within `reach`, 0 or more, of a set one along rows and columns (a square around each). `result` keeps its
// memory.
void dilate(const BitMask& mask, int reach, BitMask& result);

// The pixels further than `reach`, 0 or more, along rows and columns from every pixel that is not set; beyond the mask
// nothing is.
void erode(const BitMask& mask, int reach, BitMask& result);

// Sets what is not set and clears what is.
void complement(BitMask& mask);

// What is set in `mask` and not in `other`, of the same size. `result` may be either of them.
void subtract(const BitMask& mask, const BitMask& other, BitMask& result);

// Rows become columns. `result` keeps its memory.
void transpose(const BitMask& mask, BitMask& result);

}  // namespace markservo::imaging
