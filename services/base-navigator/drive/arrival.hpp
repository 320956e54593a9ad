#pragma once

// Whether the robot has arrived: it stands, looks until the pose is sharp, and is judged.

#include <cstdint>
#include <string>

#include "common/geometry/plane_pose.hpp"
#include "services/base-navigator/drive/situation.hpp"

namespace markservo::base_navigator {

struct ArrivalParameters {
  double position = 0.02;         // m, arrived within
  double heading = 0.052;         // rad (3 degrees), likewise
  double coarse_position = 0.03;  // m, will do once the corrections are used up or there is no room for them
  double coarse_heading = 0.087;  // rad (5 degrees), likewise
  double leave_position = 0.05;   // m, from which on an arrived robot has been moved away and drives again
  double leave_heading = 0.14;    // rad, likewise
  int corrections = 4;            // after which it takes the coarse tolerance or gives up
  double settle_time = 0.8;       // s standing before the pose is judged: at rest the reads sharpen it
  // s, while the position's sigma is above half the tolerance; reads do not tell a heading.
  double settle_time_max = 3.0;
  double standing_speed = 0.01;      // m/s; the encoders' ticks make 0.002
  double standing_turn_rate = 0.05;  // rad/s
};

// How far the robot is from its goal.
struct PoseError {
  double distance = 0.0;  // m
  double heading = 0.0;   // rad, goal minus robot
};

PoseError error_of(const geometry::PlanePose& X_WR, const geometry::PlanePose& X_WG);

// Whether that will do where nothing better can be had.
bool coarsely_there(const ArrivalParameters& parameters, const PoseError& error);

// Whether a robot that had arrived has been moved away.
bool has_left(const ArrivalParameters& parameters, const PoseError& error);

class Arrival {
 public:
  enum class Verdict {
    kWaits,     // has not stood for long enough, or the pose may still get better
    kArrived,   // within the tolerance
    kCorrects,  // outside, and one correction more is counted
    kWillDo,    // outside, all corrections used up, but coarsely there
    kGivesUp,   // outside that too: see why_given_up()
  };

  // Judges a step in which the robot is to stand at its goal; to be called in each.
  Verdict judge(const ArrivalParameters& parameters, const Situation& situation, const PoseError& error);

  // To be called at a pause for another reason: the robot has to stand for as long again.
  void interrupt() { standing_since_ = 0; }

  int corrections() const { return corrections_; }
  // Why it has given up; empty until then.
  const std::string& why_given_up() const { return why_given_up_; }

 private:
  Verdict judge_outside(const ArrivalParameters& parameters, const PoseError& error);

  int corrections_ = 0;
  std::int64_t standing_since_ = 0;  // us; 0: not standing
  std::string why_given_up_;
};

}  // namespace markservo::base_navigator
