#include "services/target-locator/image/epipolar_rows.hpp"

#include <algorithm>
#include <cmath>

namespace markservo::target_locator {

void align_rows(const PlaneImage& right, const PatchFrame& right_frame, const PatchFrame& left_frame, int left_height,
                double row_offset, PlaneImage& aligned) {
  aligned.resize(right.width, left_height);
  if (right.empty()) return;
  for (int y = 0; y < left_height; ++y) {
    const double position = right_frame.row_of(left_frame.v_of(y) + row_offset);
    // Also of what is no number.
    const double clamped = position > -1.0 ? std::min(position, static_cast<double>(right.height)) : -1.0;
    const int whole = static_cast<int>(std::floor(clamped));
    const auto fraction = static_cast<float>(clamped - whole);
    const auto line = [&right](int row) { return right.row(std::clamp(row, 0, right.height - 1)); };
    float* out = aligned.row(y);
    if (fraction < 1e-4F || fraction > 1.0F - 1e-4F) {
      const float* in = line(fraction < 0.5F ? whole : whole + 1);
      std::copy(in, in + right.width, out);
      continue;
    }
    const CubicWeights c(fraction);
    const float* p0 = line(whole - 1);
    const float* p1 = line(whole);
    const float* p2 = line(whole + 1);
    const float* p3 = line(whole + 2);
    for (int x = 0; x < right.width; ++x) out[x] = c.w[0] * p0[x] + c.w[1] * p1[x] + c.w[2] * p2[x] + c.w[3] * p3[x];
  }
}

PlaneImage align_rows(const PlaneImage& right, const PatchFrame& right_frame, const PatchFrame& left_frame,
                      int left_height, double row_offset) {
  PlaneImage aligned;
  align_rows(right, right_frame, left_frame, left_height, row_offset, aligned);
  return aligned;
}

}  // namespace markservo::target_locator
