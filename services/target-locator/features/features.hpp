#pragma once

// Feature points: the local maxima of Foerstner's weight (paper section 3.1), spread over the mark.

#include <vector>

#include "services/target-locator/features/structure_tensor.hpp"

namespace markservo::target_locator {

struct Feature {
  int column = 0;  // patch px
  int row = 0;     // patch px
  float weight = 0.0F;
};

struct FeatureParameters {
  float min_weight = 4.0F;      // (grey levels per px)^2; noise of sigma 3 alone stays below 1
  float min_roundness = 0.15F;  // edges have 0
  float trace_floor = 1.0F;     // (grey levels per px)^2, below it a patch is flat
  int max_features = 32;
};

// Local maxima (3 x 3) of W among the pixels of `mask` where W and C are large enough, at most `max_features`: the
// strongest of every cell of a grid over the mask first, so that they spread, then the strongest of the rest.
// Ordered by row, then column.
// `features` keeps its memory.
void find_features(const CornerMeasures& measures, const Mask& mask, const FeatureParameters& parameters,
                   std::vector<Feature>& features);
std::vector<Feature> find_features(const CornerMeasures& measures, const Mask& mask,
                                   const FeatureParameters& parameters);

}  // namespace markservo::target_locator
