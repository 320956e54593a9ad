#include "services/target-locator/features/structure_tensor.hpp"

#include "services/target-locator/features/tensor_kernel.hpp"

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

void foerstner(const Gradients& gradients, float trace_floor, CornerMeasures& measures) {
  measures.weight.resize(gradients.column.width, gradients.column.height);
  measures.roundness.resize(gradients.column.width, gradients.column.height);
  if (!gradients.column.empty()) fill_measures(gradients, trace_floor, measures);
}

CornerMeasures foerstner(const Gradients& gradients, float trace_floor) {
  CornerMeasures measures;
  foerstner(gradients, trace_floor, measures);
  return measures;
}

}  // namespace markservo::target_locator
