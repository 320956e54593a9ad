#pragma once

#include <optional>
#include <string>

#include "services/rfid-localizer/wheel_judge.hpp"

namespace markservo::rfid_localizer {

// What would fit in place of robot.yaml's numbers that are too small, in its units and to two digits.
struct WheelProposal {
  std::optional<double> drift_deg_per_sqrt_m;
  std::optional<double> pivot_wander;
};

WheelProposal proposal(const WheelJudgement& judgement);

// Which of robot.yaml's numbers is too small, by how much, and which would fit; empty where none is.
std::string describe(const WheelJudgement& judgement);

// When that is worth a line of its own: the judgement changes with every round.
class WheelReport {
 public:
  // The line, or nothing where what was told last still holds.
  std::string news(const WheelJudgement& judgement);

 private:
  WheelJudgement told_;
};

}  // namespace markservo::rfid_localizer
