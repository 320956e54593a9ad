#pragma once

// Sums of colours down the columns around an outline, in vector code (Highway).

#include <cstdint>
#include <vector>

namespace markservo::mark_detector {

// For each column: how many pixels are surely the mark's and the sums of their blue, green and red; then the same of
// those that surely are not.
class ColumnSums {
 public:
  enum Plane { kMarkCount, kMarkB, kMarkG, kMarkR, kRestCount, kRestB, kRestG, kRestR, kPlanes };

  static constexpr int kMaxRows = 128;  // at a time: their sums fit 16 bits

  // All zero. `width`: columns.
  explicit ColumnSums(int width);

  // Adds (`sign` 1) or takes away (-1) a row of pixels, 8-bit BGR; `mark` and `rest` are its bits, a word for each 64
  // columns, zero beyond the width.
  void add(const uint8_t* bgr, const uint64_t* mark, const uint64_t* rest, int sign);

  int at(Plane plane, int column) const { return sums_[index(plane, column)]; }

 private:
  std::size_t index(int plane, int column) const {
    return static_cast<std::size_t>(plane) * stride_ + static_cast<std::size_t>(column);
  }

  int width_;
  std::size_t stride_;
  std::vector<int16_t> sums_;
};

}  // namespace markservo::mark_detector
