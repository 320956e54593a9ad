#pragma once

// Where a cut-out lies in the camera's image.

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

}  // namespace markservo::target_locator
