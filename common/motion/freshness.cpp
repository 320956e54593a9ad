#include "common/motion/freshness.hpp"

#include <fmt/core.h>

#include <cmath>

#include "common/time/seconds_between.hpp"

namespace markservo::motion {

std::string why_not_fresh(const Freshness& rule, std::int64_t utime, std::int64_t now) {
  const double age = seconds_between(utime, now);
  if (age <= rule.older && -age <= rule.newer) return "";
  const bool old = age > 0.0;
  return fmt::format("{} is {:.2f} s {} than {}; allowed: {:.2f} s", rule.what, std::abs(age), old ? "older" : "newer",
                     rule.clock, old ? rule.older : rule.newer);
}

}  // namespace markservo::motion
