#include "services/target-locator/image/gradients.hpp"

#include "services/target-locator/image/image_kernel.hpp"

namespace markservo::target_locator {

void sobel_gradients(const PlaneImage& image, bool zero_border, Gradients& gradients) {
  gradients.column.resize(image.width, image.height);
  gradients.row.resize(image.width, image.height);
  if (!image.empty()) fill_gradients(image, zero_border, gradients);
}

Gradients sobel_gradients(const PlaneImage& image, bool zero_border) {
  Gradients gradients;
  sobel_gradients(image, zero_border, gradients);
  return gradients;
}

}  // namespace markservo::target_locator
