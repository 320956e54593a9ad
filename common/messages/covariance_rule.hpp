#pragma once

// What a Covariance3 in a message may be.

#include <cmath>
#include <markservo/Covariance3.hpp>
#include <string>

#include "common/messages/rule_words.hpp"

namespace markservo::messages {

inline std::string covariance_violation(const Covariance3& c, double most) {
  if (!all_finite({c.xx, c.xy, c.xz, c.yy, c.yz, c.zz})) return not_finite("covariance");
  for (const double variance : {c.xx, c.yy, c.zz}) {
    if (variance < 0.0 || variance > most) {
      return wrong("covariance", variance, "0 to " + std::to_string(static_cast<int>(most)) + " m^2 on the diagonal");
    }
  }
  return {};
}

}  // namespace markservo::messages
