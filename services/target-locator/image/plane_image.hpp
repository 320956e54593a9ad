#pragma once

// A grey image of floats, and the mask of a mark.

#include <algorithm>
#include <cstddef>
#include <vector>

#include "common/imaging/bit_mask.hpp"

namespace markservo::target_locator {

// Grey values, 0..255 or any linear combination of colours. Around each row there is room that vectors may read and
// write: kRoom pixels before column 0 and behind the last column, of no meaning.
class PlaneImage {
 public:
  static constexpr int kRoom = 16;  // floats of the longest vectors

  int width = 0;
  int height = 0;

  PlaneImage() = default;
  PlaneImage(int width_in, int height_in, float value = 0.0F) {
    resize(width_in, height_in);
    std::fill(data_.begin(), data_.end(), value);
  }
  // Another size; pixels have any value. Keeps its memory.
  void resize(int width_in, int height_in) {
    width = width_in;
    height = height_in;
    constexpr std::ptrdiff_t kStep = kRoom;
    stride_ = (width + kStep - 1) / kStep * kStep + kStep;
    data_.resize(static_cast<std::size_t>(stride_ * height + 3 * kStep));
  }

  float* row(int y) { return data_.data() + kRoom + stride_ * y; }
  const float* row(int y) const { return data_.data() + kRoom + stride_ * y; }
  float& at(int x, int y) { return row(y)[x]; }
  const float& at(int x, int y) const { return row(y)[x]; }
  std::ptrdiff_t stride() const { return stride_; }  // floats from row to row
  bool empty() const { return width <= 0 || height <= 0; }

 private:
  std::ptrdiff_t stride_ = 0;
  std::vector<float> data_;
};

using Mask = imaging::BitMask;  // set where the mark is

}  // namespace markservo::target_locator
