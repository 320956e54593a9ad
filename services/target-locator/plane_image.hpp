#pragma once

// A grey image of floats and where its pixels lie in the camera's image.

#include <cstddef>
#include <vector>

namespace markservo::target_locator {

// Where the pixels of a cut-out lie in the image it was cut from, by area-averaging `scale` x `scale` pixels each.
// Pixel centres are at integers in both.
struct PatchFrame {
  double x = 0.0;      // px of the image, leftmost column covered
  double y = 0.0;      // px of the image, topmost row covered
  double scale = 1.0;  // image pixels per patch pixel, above 0

  double u_of(double column) const { return x + (column + 0.5) * scale - 0.5; }
  double v_of(double row) const { return y + (row + 0.5) * scale - 0.5; }
  double column_of(double u) const { return (u - x + 0.5) / scale - 0.5; }
  double row_of(double v) const { return (v - y + 0.5) / scale - 0.5; }
};

// Row by row, no padding.
template <typename Pixel>
struct Grid {
  int width = 0;
  int height = 0;
  std::vector<Pixel> data;

  Grid() = default;
  Grid(int width_in, int height_in, Pixel value = Pixel())
      : width(width_in),
        height(height_in),
        data(static_cast<std::size_t>(width_in) * static_cast<std::size_t>(height_in), value) {}

  Pixel* row(int y) { return data.data() + static_cast<std::ptrdiff_t>(y) * width; }
  const Pixel* row(int y) const { return data.data() + static_cast<std::ptrdiff_t>(y) * width; }
  Pixel& at(int x, int y) { return row(y)[x]; }
  const Pixel& at(int x, int y) const { return row(y)[x]; }
  bool empty() const { return data.empty(); }
};

using PlaneImage = Grid<float>;    // grey values, 0..255 or any linear combination of colours
using Mask = Grid<unsigned char>;  // 1 where the mark is, else 0

}  // namespace markservo::target_locator
