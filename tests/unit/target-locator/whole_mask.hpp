#pragma once

#include "services/target-locator/image/plane_image.hpp"

namespace markservo::target_locator::test {

// All set.
inline Mask whole_mask(int width, int height) {
  Mask mask(width, height);
  for (int y = 0; y < height; ++y) mask.set_run(y, 0, width);
  return mask;
}

}  // namespace markservo::target_locator::test
