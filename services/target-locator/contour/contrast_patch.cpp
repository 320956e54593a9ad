#include "services/target-locator/contour/contrast_patch.hpp"

#include <cmath>

#include "services/target-locator/image/colour_projection.hpp"
#include "services/target-locator/image/epipolar_rows.hpp"

namespace markservo::target_locator {
namespace {

// With weights of unit length.
ColourMap in_levels(const ColourMap& map) {
  ColourMap scaled = map;
  const float norm =
      std::sqrt(map.weights[0] * map.weights[0] + map.weights[1] * map.weights[1] + map.weights[2] * map.weights[2]);
  for (float& weight : scaled.weights) weight /= norm;
  scaled.offset /= norm;
  return scaled;
}

}  // namespace

std::optional<StereoPatch> contrast_patch(const MarkObservation& observation, const MarkImages& images) {
  const Contrast contrast = mark_contrast(images.left_colours);
  if (!contrast.valid) return std::nullopt;
  const ColourMap map = in_levels(contrast.map);
  StereoPatch patch;
  patch.left_frame = images.patch.left_frame;
  patch.right_frame = images.patch.right_frame;
  project_colours(observation.left.patch, map, patch.left);
  project_colours(observation.right.patch, map, patch.right);
  sobel_gradients(patch.left, false, patch.left_gradients);
  align_rows(patch.right, patch.right_frame, patch.left_frame, patch.left.height, 0.0, patch.right_rows);
  return patch;
}

}  // namespace markservo::target_locator
