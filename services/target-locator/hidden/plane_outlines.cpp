#include "services/target-locator/hidden/plane_outlines.hpp"

#include <algorithm>
#include <cstddef>

namespace markservo::target_locator {
namespace {

constexpr std::size_t kLeastPoints = 60;

// Calls `use(column, row)` for every place between a pixel of the mask and one that is not.
template <typename Use>
void for_each_edge(const Mask& mask, const Use& use) {
  const auto at = [&mask](int x, int y) {
    return x >= 0 && y >= 0 && x < mask.width() && y < mask.height() && mask.test(x, y);
  };
  for (int y = 0; y < mask.height(); ++y) {
    for (int x = -1; x < mask.width(); ++x) {
      if (at(x, y) != at(x + 1, y)) use(x + 0.5, static_cast<double>(y));
    }
  }
  for (int y = -1; y < mask.height(); ++y) {
    for (int x = 0; x < mask.width(); ++x) {
      if (at(x, y) != at(x, y + 1)) use(static_cast<double>(x), y + 0.5);
    }
  }
}

}  // namespace

std::optional<PlaneOutlines> outlines_on_plane(const MaskedView& left, const MaskedView& right, const PlaneAxes& axes,
                                               const DisparityPlane& plane, double row_offset, double fx) {
  PlaneOutlines outlines;
  bool in_front = true;
  const auto add = [&](std::size_t view, double u_left, double v) {
    const auto place = axes.place(u_left, v);
    if (place) {
      outlines.views[view].push_back(*place);
    } else {
      in_front = false;
    }
  };
  for_each_edge(left.mask, [&](double column, double row) { add(0, left.frame.u_of(column), left.frame.v_of(row)); });
  for_each_edge(right.mask, [&](double column, double row) {
    const double u = right.frame.u_of(column);
    const double v = right.frame.v_of(row) - row_offset;
    // The plane's disparity is linear in u_left = u + disparity.
    add(1, u + plane.at(u, v) / (1.0 - plane.along_u), v);
  });
  if (!in_front || outlines.views[0].size() < kLeastPoints || outlines.views[1].size() < kLeastPoints) {
    return std::nullopt;
  }
  outlines.pixel = axes.depth() / fx * std::max(left.frame.scale, right.frame.scale);
  return outlines;
}

}  // namespace markservo::target_locator
