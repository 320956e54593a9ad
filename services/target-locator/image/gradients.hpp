#pragma once

// How grey changes along rows and columns.

#include "services/target-locator/image/plane_image.hpp"

namespace markservo::target_locator {

struct Gradients {
  PlaneImage column;  // g_c, grey levels per px along u: Sobel 3 x 3 over 8
  PlaneImage row;     // g_r, grey levels per px along v
  PlaneImage lines;   // room for making them
};

// Sobel gradients of `image`; beyond the border the image is 0 when `zero_border`, else its border pixels repeat.
// `gradients` keeps its memory.
void sobel_gradients(const PlaneImage& image, bool zero_border, Gradients& gradients);
Gradients sobel_gradients(const PlaneImage& image, bool zero_border = false);

}  // namespace markservo::target_locator
