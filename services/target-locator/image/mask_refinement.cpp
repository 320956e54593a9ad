#include "services/target-locator/image/mask_refinement.hpp"

#include <Eigen/Core>
#include <algorithm>

namespace markservo::target_locator {
namespace {

// Mean colour of the chosen pixels of a square window; count 0 if there are none.
struct LocalColour {
  double count = 0.0;
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
};

Eigen::Vector3d colour_at(const Patch& patch, int x, int y) {
  const std::uint8_t* p = patch.bgr + 3 * (static_cast<std::ptrdiff_t>(y) * patch.width + x);
  return {static_cast<double>(p[0]), static_cast<double>(p[1]), static_cast<double>(p[2])};
}

LocalColour colour_around(const Patch& patch, const Mask& chosen, int x, int y, int reach) {
  LocalColour local;
  for (int row = std::max(0, y - reach); row <= std::min(patch.height - 1, y + reach); ++row) {
    const int end = std::min(patch.width, x + reach + 1);
    for (int column = chosen.next(row, std::max(0, x - reach), true); column < end;
         column = chosen.next(row, column + 1, true)) {
      local.mean += colour_at(patch, column, row);
      local.count += 1.0;
    }
  }
  if (local.count > 0.0) local.mean /= local.count;
  return local;
}

}  // namespace

Mask half_covered(const Patch& patch, const Mask& mask, const MaskRefinementParameters& parameters) {
  Mask inside;
  Mask outside;
  imaging::erode(mask, parameters.band, inside);
  imaging::dilate(mask, parameters.band, outside);
  imaging::complement(outside);
  Mask refined = mask;
  for (int y = 0; y < mask.height(); ++y) {
    for (int x = 0; x < mask.width(); ++x) {
      if (inside.test(x, y) || outside.test(x, y)) continue;
      const LocalColour mark = colour_around(patch, inside, x, y, parameters.reach);
      const LocalColour rest = colour_around(patch, outside, x, y, parameters.reach);
      if (mark.count == 0.0 || rest.count == 0.0) continue;
      const Eigen::Vector3d step = mark.mean - rest.mean;
      const double contrast_2 = step.squaredNorm();
      if (contrast_2 < parameters.contrast_min * parameters.contrast_min) continue;
      const Eigen::Vector3d off = colour_at(patch, x, y) - rest.mean;
      const double share = off.dot(step) / contrast_2;
      const double beside_2 = (off - share * step).squaredNorm();
      if (beside_2 > parameters.beside_max * parameters.beside_max * contrast_2) continue;
      refined.set(x, y, share >= 0.5);
    }
  }
  return refined;
}

}  // namespace markservo::target_locator
