#pragma once

// When the arm counts as at rest, and the average of what is seen of it then.

#include <Eigen/Core>
#include <cstdint>
#include <deque>
#include <optional>

#include "services/visual-servo/arm/joint_history.hpp"

namespace markservo::visual_servo {

struct SettlingParameters {
  double arrival_tolerance =
      0.0009;  // rad (0.05 degrees, 0.25 mm at the grip point): RC controllers round to 0.02 degrees
  double rest_time =
      0.3;  // s; joint states that stay off the command (deadband, when shafts are measured) count as arrived
  double settle_time = 0.04;  // s for the shafts to come to rest after the ramp's end
  int frames = 4;             // averaged: noise of 0.2 mm becomes 0.1 mm
  int frames_in_doubt = 8;    // averaged where that leaves a doubt: four more cost less than a correction's twelve
  int patience = 12;          // frames after which a restless average is taken as it is
  double spread = 0.0012;     // m; farther from the average means still moving (noise of 0.2 mm an axis stays below)
};

// The utime since which all that was commanded has been carried out; nothing while something is in flight.
// `command_utime`: when `q_command` was first commanded, on the joints' clock. Requires !joints.empty().
std::optional<std::int64_t> at_rest_since(const SettlingParameters& parameters, const JointHistory& joints,
                                          const JointVector& q_command, std::int64_t command_utime);

// The newest samples of a point at rest.
class SettledWindow {
 public:
  void forget();
  void add(const SettlingParameters& parameters, const Eigen::Vector3d& p);
  // What it holds leaves a doubt: nothing more is forgotten until `frames_in_doubt` are there.
  void look_longer() { in_doubt_ = true; }

  // Whether there are enough samples that agree, or it has waited for long enough.
  bool ready(const SettlingParameters& parameters) const;
  int size() const { return static_cast<int>(samples_.size()); }
  Eigen::Vector3d mean() const;

 private:
  std::deque<Eigen::Vector3d> samples_;
  int seen_ = 0;
  bool in_doubt_ = false;
};

}  // namespace markservo::visual_servo
