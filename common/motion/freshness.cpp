#include "common/motion/freshness.hpp"

#include <array>
#include <cmath>
#include <cstdio>

#include "common/time/seconds_between.hpp"

namespace markservo::motion {

std::string why_not_fresh(const Freshness& rule, std::int64_t utime, std::int64_t now) {
  const double age = seconds_between(utime, now);
  if (age <= rule.older && -age <= rule.newer) return "";
  std::array<char, 160> text{};
  std::snprintf(text.data(), text.size(), "%s is %.2f s %s than %s; allowed: %.2f s", rule.what, std::abs(age),
                age > 0.0 ? "older" : "newer", rule.clock, age > 0.0 ? rule.older : rule.newer);
  return text.data();
}

}  // namespace markservo::motion
