#include "services/target-locator/image/mark_images.hpp"

#include "services/target-locator/image/epipolar_rows.hpp"

namespace markservo::target_locator {

void make_mark_images(const View& left, const View& right, MarkImages& images) {
  prepare_masks(left.patch, images.left);
  prepare_masks(right.patch, images.right);
  images.left_colours = mark_colours(left.patch, images.left);
  const ColourMap axis = texture_axis(images.left_colours.inside);
  StereoPatch& patch = images.patch;
  project_colours(left.patch, axis, patch.left);
  project_colours(right.patch, axis, patch.right);
  patch.left_frame = left.patch.frame;
  patch.right_frame = right.patch.frame;
  sobel_gradients(patch.left, false, patch.left_gradients);
  align_rows(patch.right, patch.right_frame, patch.left_frame, patch.left.height, 0.0, patch.right_rows);
}

}  // namespace markservo::target_locator
