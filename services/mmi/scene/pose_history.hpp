#pragma once

#include <cstdint>
#include <deque>
#include <optional>

#include "services/mmi/scene/reports.hpp"

namespace markservo::mmi {

// Where the robot was: the last seconds of ROBOT_POSE.
class PoseHistory {
 public:
  struct Parameters {
    std::size_t most = 1000;  // poses: 200 Hz for as long
    double kept = 5.0;        // s: rounds arrive 0.2 s after their middle, up to 1 s of slow readers
    double gap_max = 1.0;     // s between two poses: without encoders one comes with each round
    double hold_max = 0.1;    // s after the newest, which counts as still: 5 poses at 50 Hz
  };

  PoseHistory() : PoseHistory(Parameters{}) {}
  explicit PoseHistory(const Parameters& parameters) : parameters_(parameters) {}

  // A pose of another session, or of a time before the newest's, begins anew.
  void add(const PoseReport& pose);

  // X_WR at `utime` (us), between the poses around it; nothing where these are missing, too far apart or not localised.
  std::optional<geometry::PlanePose> at(std::int64_t utime) const;
  // s, from the middle of a round to its arrival, as the newest pose estimates it; nothing before the first.
  std::optional<double> delay() const;

 private:
  Parameters parameters_;
  std::deque<PoseReport> poses_;  // the newest at the end; without reasons
};

}  // namespace markservo::mmi
