#include "services/target-locator/contour/outline_band.hpp"

#include <cmath>
#include <cstdint>

#include "services/target-locator/contour/contrast_patch.hpp"

namespace markservo::target_locator {
namespace {

Mask band_about(const Mask& mask, int half_width) {
  Mask band;
  Mask inner;
  imaging::dilate(mask, half_width, band);
  imaging::erode(mask, half_width, inner);
  for (int y = 0; y < band.height(); ++y) {
    std::uint64_t* words = band.row(y);
    const std::uint64_t* inside = static_cast<const Mask&>(inner).row(y);
    for (int i = 0; i < band.words_per_row(); ++i) words[i] &= ~inside[i];
  }
  return band;
}

}  // namespace

std::optional<PlaneAlignment> plane_of_outline(const MarkObservation& observation, const MarkImages& images,
                                               const OutlineBandParameters& parameters) {
  const auto seed =
      plane_of_masks(images.left.mask, images.patch.left_frame, images.right.mask, images.patch.right_frame);
  const auto patch = contrast_patch(observation, images);
  if (!seed || !patch) return std::nullopt;
  const Mask band = band_about(images.left.mask, parameters.half_width);
  const auto plane = align_plane(*patch, band, *seed, parameters.alignment);
  if (!plane || !(std::sqrt(plane->covariance(0, 0)) <= parameters.max_centre_sigma) ||
      !(plane->correlation >= parameters.min_correlation) ||
      !(std::abs(plane->row_offset) <= parameters.max_row_offset)) {
    return std::nullopt;
  }
  return plane;
}

}  // namespace markservo::target_locator
