#pragma once

// One bit a pixel, rows padded to whole 64-bit words, lowest bit first; the padding is zero.

#include <cstddef>
#include <cstdint>
#include <vector>

namespace markservo::mark_detector {

class BitMask {
 public:
  static constexpr int kWordBits = 64;

  BitMask() = default;
  // All clear. Sizes of 0 or more.
  BitMask(int width, int height);
  // Another size, all clear; as it is when the size is the same.
  void resize(int width, int height) {
    if (width != width_ || height != height_) *this = BitMask(width, height);
  }

  int width() const { return width_; }
  int height() const { return height_; }
  int words_per_row() const { return words_per_row_; }

  uint64_t* row(int v) { return words_.data() + offset(v); }
  const uint64_t* row(int v) const { return words_.data() + offset(v); }

  bool test(int u, int v) const { return (row(v)[u / kWordBits] >> (u % kWordBits)) & 1U; }
  void set(int u, int v, bool value) {
    const uint64_t bit = uint64_t{1} << (u % kWordBits);
    uint64_t& word = row(v)[u / kWordBits];
    word = value ? word | bit : word & ~bit;
  }
  // Sets the pixels [begin, end) of row v.
  void set_run(int v, int begin, int end);

  bool row_empty(int v) const;
  // First pixel at or after `u` in row v whose bit is `wanted`, or the width.
  int next(int v, int u, bool wanted) const;
  // The 64 pixels of row v from column u on, lowest bit first; zero beyond the mask, on every side.
  uint64_t window(int u, int v) const;

  // Number of set pixels.
  int64_t count() const;

  bool operator==(const BitMask& other) const {
    return width_ == other.width_ && height_ == other.height_ && words_ == other.words_;
  }

 private:
  std::size_t offset(int v) const { return static_cast<std::size_t>(v) * static_cast<std::size_t>(words_per_row_); }

  int width_ = 0;
  int height_ = 0;
  int words_per_row_ = 0;
  std::vector<uint64_t> words_;
};

// 3 x 3 majority: a pixel is set if at least 5 of the 9 around it are; outside the image the border repeats. Takes away
// lone pixels and fills single holes, and leaves straight edges where they are.
BitMask majority3(const BitMask& mask);

// Every pixel within `reach`, 0 or more, of a set one along rows and columns (a square around each).
BitMask dilate(const BitMask& mask, int reach);

// What is not set.
BitMask complement(const BitMask& mask);

}  // namespace markservo::mark_detector
