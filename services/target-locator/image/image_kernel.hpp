#pragma once

// From colours to grey planes and from these to gradients, in vector code (Highway). Last bits depend on the
// processor's instruction set.

#include <array>
#include <cstdint>

#include "services/target-locator/image/gradients.hpp"
#include "services/target-locator/image/plane_image.hpp"

namespace markservo::target_locator {

// weights . (B, G, R) + offset.
struct ColourMap {
  std::array<float, 3> weights{};
  float offset = 0.0F;
};

// `plane` gets the map of every pixel of a patch of `width` x `height` pixels, rows without gaps.
void project_pixels(const std::uint8_t* bgr, int width, int height, const ColourMap& map, PlaneImage& plane);

// Does what sobel_gradients() does, to gradients that have the image's size.
void fill_gradients(const PlaneImage& image, bool zero_border, Gradients& gradients);

}  // namespace markservo::target_locator
