#pragma once

// How large a misfit chance explains.

#include <algorithm>
#include <cmath>

namespace markservo::target_locator {

// The chi-square per degree of freedom, 1 or more of them, below which 99% of draws lie (Wilson and Hilferty 1931; to
// half a per cent from two degrees of freedom on).
inline double explained_by_chance(double degrees_of_freedom) {
  constexpr double kOneInHundred = 2.3263;  // sigmas of a normal distribution
  const double spread = 2.0 / (9.0 * std::max(1.0, degrees_of_freedom));
  const double root = 1.0 - spread + kOneInHundred * std::sqrt(spread);
  return root * root * root;
}

}  // namespace markservo::target_locator
