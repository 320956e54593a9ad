#include "services/base-navigator/obstacles/scan_check.hpp"

#include <fmt/format.h>

namespace markservo::base_navigator {
namespace {

constexpr double kMounting_m = 0.05;  // a sonar may be mounted so much farther out than robot.yaml's ring
constexpr double kUnlike = 2.0;       // times robot.yaml's value, or that part of it: another kind of sonar

// Empty unless a scan's value differs so much from robot.yaml's that its echoes mean something else.
std::string why_unlike(const char* what, double value, double configured, const char* unit) {
  if (value >= configured / kUnlike && value <= configured * kUnlike) return "";
  return fmt::format("{} is {:.3f} {}; allowed: {:.3f} to {:.3f} (robot.yaml: {:.3f})", what, value, unit,
                     configured / kUnlike, configured * kUnlike, configured);
}

}  // namespace

std::string ScanCheck::why_refused(const SonarScanSample& scan) const {
  if (static_cast<int>(scan.readings.size()) != sonars_.number) {
    return "a scan of " + std::to_string(scan.readings.size()) + " sonars; allowed: " + std::to_string(sonars_.number) +
           " as in robot.yaml";
  }
  if (auto why = why_unlike("min_range", scan.min_range, sonars_.min_range, "m"); !why.empty()) return why;
  if (auto why = why_unlike("max_range", scan.max_range, sonars_.max_range, "m"); !why.empty()) return why;
  if (auto why = why_unlike("beam_width", scan.beam_width, sonars_.beam_width, "rad"); !why.empty()) return why;
  for (std::size_t i = 0; i < scan.readings.size(); ++i) {
    const double off = scan.readings[i].X_RS.distance();
    if (off <= sonars_.ring_radius + kMounting_m) continue;
    return fmt::format("sonar {} is {:.2f} m from the robot's origin; allowed: {:.2f} m (ring_radius + {:.2f})", i, off,
                       sonars_.ring_radius + kMounting_m, kMounting_m);
  }
  return "";
}

}  // namespace markservo::base_navigator
