#pragma once

// From colours to grey planes, in vector code (Highway).

#include <array>
#include <cstdint>

#include "services/target-locator/image/plane_image.hpp"

namespace markservo::target_locator {

// weights . (B, G, R) + offset.
struct ColourMap {
  std::array<float, 3> weights{};
  float offset = 0.0F;
};

// `plane` gets the map of every pixel of a patch of `width` x `height` pixels, rows without gaps.
void project_pixels(const std::uint8_t* bgr, int width, int height, const ColourMap& map, PlaneImage& plane);

}  // namespace markservo::target_locator
