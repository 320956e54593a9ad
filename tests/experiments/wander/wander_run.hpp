#pragma once

// The localizer's own core on a drive, without bus and clock, scored.

#include <optional>
#include <string>
#include <vector>

#include "common/robot/robot_description.hpp"
#include "services/rfid-localizer/wheel_judge.hpp"
#include "tests/experiments/localisation/recorded_drive.hpp"

namespace markservo::experiments {

struct WanderRun {
  std::string tag_field;
  bool judging = true;      // else the localizer believes what is stated, whatever the tags say
  double settling = 120.0;  // s that are not scored
};

struct LostSpell {
  double begin = 0.0;     // s since the drive's begin
  double duration = 0.0;  // s
  std::string reason;     // at its begin
};

// Over the samples at 50 Hz after the settling, where nothing else is said.
struct WanderScore {
  double error = 0.0;                                    // m, mean radial error of the live pose
  double heading_error = 0.0;                            // rad, mean absolute, while driving
  double nees = 0.0;                                     // mean, of (x, y, heading), where it claims to be localised
  double not_localised = 0.0;                            // share of the samples
  std::vector<LostSpell> lost;                           // from the begin on
  std::optional<rfid_localizer::WheelJudgement> wheels;  // at the end; nothing: not judged
};

WanderScore localise_in_process(const Drive& drive, const robot::RobotDescription& robot, const WanderRun& run);

// m, the Fisher bound's mean radial error over the same samples. `wheels` is how they truly err.
double mean_bound(const Drive& drive, const robot::RobotDescription& robot, const WanderRun& run,
                  const simulator::BaseModelParameters& wheels);

}  // namespace markservo::experiments
