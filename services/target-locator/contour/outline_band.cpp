#include "services/target-locator/contour/outline_band.hpp"

#include "services/target-locator/contour/contrast_patch.hpp"

namespace markservo::target_locator {
namespace {

Mask band_about(const Mask& mask, int half_width) {
  Mask band;
  Mask inner;
  imaging::dilate(mask, half_width, band);
  imaging::erode(mask, half_width, inner);
  imaging::subtract(band, inner, band);
  return band;
}

}  // namespace

std::optional<PlaneAlignment> plane_of_outline(const MarkObservation& observation, const MarkImages& images,
                                               const OutlineBandParameters& parameters) {
  const auto seed =
      plane_of_masks(images.left.mask, images.patch.left_frame, images.right.mask, images.patch.right_frame);
  auto patch = contrast_patch(observation, images);
  if (!seed || !patch) return std::nullopt;
  const Mask band = band_about(images.left.mask, parameters.half_width);
  const auto first = align_plane(*patch, band, *seed, parameters.alignment);
  const auto plane = with_rows_aligned(*patch, band, first, parameters.limits, parameters.alignment);
  return is_known(plane, parameters.limits) && is_one_mark(*plane, parameters.limits) ? plane : std::nullopt;
}

}  // namespace markservo::target_locator
