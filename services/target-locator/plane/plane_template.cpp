#include "services/target-locator/plane/plane_template.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "services/target-locator/plane/plane_kernel.hpp"

namespace markservo::target_locator {
namespace {

// Sums over chosen pixels of patch coordinates.
struct Extent {
  double n = 0.0;
  double x = 0.0;
  double y = 0.0;
  double squares = 0.0;

  void add(int column, int row, std::uint64_t bits) {
    const double count = imaging::count_bits(bits);
    // As if a block's pixels lay at the middle of its ends: what the centre and the scale need.
    const double middle = column + 0.5 * (__builtin_ctzll(bits) + 63 - __builtin_clzll(bits));
    n += count;
    x += count * middle;
    y += count * row;
    squares += count * (middle * middle + static_cast<double>(row) * row);
  }
};

}  // namespace

void make_template(const StereoPatch& patch, const Mask& mask, int limit, PlaneTemplate& t) {
  constexpr int kLanes = PlaneTemplate::kLanes;
  t.blocks.clear();
  t.count = 0;
  t.weight.clear();
  const auto total = static_cast<int>(mask.count());
  if (total == 0) return;
  const int row_step = std::max(1, static_cast<int>(std::lround(static_cast<double>(total) / std::max(1, limit))));
  const int last_column = mask.width() - 2;  // central differences need a neighbour
  Extent extent;
  for (int y = row_step / 2; y < mask.height(); y += row_step) {
    if (mask.surely_empty(y)) continue;
    for (int x = std::max(1, mask.next(y, 0, true)); x <= last_column;) {
      const std::uint64_t reach = imaging::low_bits(std::min(kLanes, last_column - x + 1));
      const std::uint64_t bits = mask.window(x, y) & reach;
      if (bits != 0) {
        t.blocks.push_back({x, y});
        for (int lane = 0; lane < kLanes; ++lane) t.weight.push_back(static_cast<float>((bits >> lane) & 1U));
        extent.add(x, y, bits);
      }
      x = mask.next(y, x + kLanes, true);
    }
  }
  if (t.blocks.empty()) return;
  t.count = static_cast<std::size_t>(extent.n);
  const double cx = extent.x / extent.n;
  const double cy = extent.y / extent.n;
  const double spread = std::sqrt(std::max(1.0, extent.squares / extent.n - cx * cx - cy * cy));
  const PatchFrame& frame = patch.left_frame;
  t.origin = {frame.u_of(cx), frame.v_of(cy), spread * frame.scale};
  fill_template(patch, {cx, cy, 1.0 / spread}, t);
}

void warp(const StereoPatch& patch, const PlaneTemplate& pixels, const DisparityPlane& plane,
          std::vector<float>& warped) {
  // column_right = (u_left - disparity - x_right + 0.5) / scale_right - 0.5, with u_left and v linear in left columns
  // and rows.
  const PatchFrame& left = patch.left_frame;
  const PatchFrame& right = patch.right_frame;
  ColumnMap map;
  map.base = right.column_of(left.u_of(0.0) - plane.at(left.u_of(0.0), left.v_of(0.0)));
  map.per_column = (1.0 - plane.along_u) * left.scale / right.scale;
  map.per_row = -plane.along_v * left.scale / right.scale;
  warped.resize(pixels.padded());
  sample_rows(patch.right_rows, pixels, map, warped.data());
}

double correlation_of(const PlaneTemplate& t, const std::vector<float>& warped) {
  const ProductSums s = sum_products(t, warped.data());
  if (s.n < 2.0) return 0.0;
  const double variance = (s.aa - s.a * s.a / s.n) * (s.bb - s.b * s.b / s.n);
  return variance > 0.0 ? (s.ab - s.a * s.b / s.n) / std::sqrt(variance) : 0.0;
}

}  // namespace markservo::target_locator
