#include "services/rfid-localizer/wheel_report.hpp"

#include <fmt/core.h>

#include <cmath>

#include "common/geometry/plane_pose.hpp"

namespace markservo::rfid_localizer {
namespace {

constexpr double kNews = 1.25;  // what fits has changed by this factor

// Of a number above 0.
double to_two_digits(double number) {
  const double last = std::pow(10.0, std::floor(std::log10(number)) - 1.0);
  return std::round(number / last) * last;
}

std::string describe(const char* key, double stated, double fits, const char* unit) {
  if (stated <= 0.0) return fmt::format("{} is {:g}, {:.2g} {} would fit", key, stated, fits, unit);
  return fmt::format("{} is {:.3g}, {:.1f} times too small: {:.2g} {} would fit", key, stated, fits / stated, fits,
                     unit);
}

bool differ(const JudgedNumber& a, const JudgedNumber& b) {
  if (a.too_small != b.too_small) return true;
  return a.too_small && std::abs(std::log(a.fits / b.fits)) > std::log(kNews);
}

}  // namespace

WheelProposal proposal(const WheelJudgement& judgement) {
  WheelProposal result;
  if (judgement.drift.too_small) {
    result.drift_deg_per_sqrt_m = to_two_digits(geometry::degrees(judgement.drift.fits));
  }
  if (judgement.pivot_wander.too_small) result.pivot_wander = to_two_digits(judgement.pivot_wander.fits);
  return result;
}

std::string describe(const WheelJudgement& judgement) {
  std::string text;
  const auto add = [&text](const std::string& more) { text += (text.empty() ? "" : "; ") + more; };
  if (judgement.drift.too_small) {
    add(describe("base.odometry.drift_deg_per_sqrt_m", geometry::degrees(judgement.drift.stated),
                 geometry::degrees(judgement.drift.fits), "deg/sqrt(m)"));
  }
  if (judgement.pivot_wander.too_small) {
    add(describe("base.odometry.pivot_wander", judgement.pivot_wander.stated, judgement.pivot_wander.fits,
                 "m/sqrt(rad)"));
  }
  return text;
}

std::string WheelReport::news(const WheelJudgement& judgement) {
  if (!differ(judgement.drift, told_.drift) && !differ(judgement.pivot_wander, told_.pivot_wander)) return {};
  told_ = judgement;
  const std::string text = describe(judgement);
  if (text.empty()) return "the wheels are as good as robot.yaml states";
  return "the wheels are worse than robot.yaml states, and believed less: " + text;
}

}  // namespace markservo::rfid_localizer
