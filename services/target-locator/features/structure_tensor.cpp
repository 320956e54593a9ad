#include "services/target-locator/features/structure_tensor.hpp"

#include "services/target-locator/features/tensor_kernel.hpp"

namespace markservo::target_locator {

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
