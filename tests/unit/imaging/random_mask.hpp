#pragma once

#include <random>

#include "common/imaging/bit_mask.hpp"

namespace markservo::imaging::test {

// Each pixel set with that probability. Rows without one stay unused.
inline BitMask random_mask(int width, int height, double share, unsigned seed) {
  std::mt19937 random(seed);
  std::bernoulli_distribution set(share);
  BitMask mask(width, height);
  for (int v = 0; v < height; ++v) {
    for (int u = 0; u < width; ++u) {
      if (set(random)) mask.set(u, v, true);
    }
  }
  return mask;
}

}  // namespace markservo::imaging::test
