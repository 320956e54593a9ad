#pragma once

#include <string>

#include "common/robot/robot_description.hpp"
#include "services/base-navigator/navigator_types.hpp"

namespace markservo::base_navigator {

// Consistency check of a SONAR_SCAN with robot.yaml's ring: from other sonars the same echoes mean something else.
class ScanCheck {
 public:
  explicit ScanCheck(const robot::SonarRingDescription& sonars) : sonars_(sonars) {}

  // What differs, its value and what is allowed; empty when nothing does.
  std::string why_refused(const SonarScanSample& scan) const;

 private:
  robot::SonarRingDescription sonars_;
};

}  // namespace markservo::base_navigator
