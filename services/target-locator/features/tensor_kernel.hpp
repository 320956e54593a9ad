#pragma once

// Foerstner's interest operator in vector code (Highway). Last bits depend on the processor's instruction set.

#include <cstdint>

#include "services/target-locator/features/structure_tensor.hpp"

namespace markservo::target_locator {

// Does what foerstner() does, to measures that have the image's size.
void fill_measures(const Gradients& gradients, float trace_floor, CornerMeasures& measures);

// The local maxima (3 x 3) of a row `y` of the weight among the pixels of `inside` (words of the mask's row) with
// weight and roundness of the least or more. On a plateau the first pixel in reading order stands for it. `maxima`: as
// many words.
void find_maxima(const CornerMeasures& measures, int y, float min_weight, float min_roundness,
                 const std::uint64_t* inside, std::uint64_t* maxima);

}  // namespace markservo::target_locator
