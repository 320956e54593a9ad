#pragma once

// How the robot drove, by the simulator's truth: the way, what the services took it for, and whether it stood while the
// arm worked.

#include <cstdint>
#include <deque>
#include <markservo/RobotPose.hpp>
#include <markservo/SimBaseTruth.hpp>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>
#include <vector>

#include "common/bus/bus.hpp"

namespace markservo::experiments {

// A distance on the floor and an angle.
struct PoseError {
  double position = 0.0;  // m
  double heading = 0.0;   // rad, absolute
};

// The difference of two poses in one frame.
PoseError pose_error(const Pose2& a, const Pose2& b);

struct DriveResult {
  bool known = false;                  // SIM_BASE_TRUTH was heard
  int drives = 0;                      // the first, and corrections
  double seconds = 0.0;                // of the world's time, in them
  double way = 0.0;                    // m, while driving
  double strayed = 0.0;                // m, way outside of drives, while the task ran
  std::optional<double> moved_at_end;  // m, when all should be at rest; absent: never watched
  bool touched = false;                // the base ran into something
  double nearest = 0.0;                // m, least distance of the robot's outline to anything
  PoseError error;         // true pose minus the goal's, after the first drive: a correction has another goal
  PoseError told_error;    // ROBOT_POSE minus the true pose, then
  double told_mean = 0.0;  // m, mean and maximum of that over all drives
  double told_max = 0.0;
};

class DriveWatch {
 public:
  explicit DriveWatch(bus::Bus& bus);
  // `phase`: the task's state from now on; to be called at every frame of the task.
  void observe(std::int8_t phase);
  // From now on the base must rest.
  void expect_rest() { rest_since_way_ = way_ + strayed_; }
  DriveResult result(const Pose2& goal) const;

  // Poses over the drives and all that was between: true ones, and what ROBOT_POSE said while it was localised.
  const std::vector<Pose2>& true_way() const { return true_way_; }
  const std::vector<Pose2>& told_way() const { return told_way_; }

 private:
  void note(const SimBaseTruth& truth);
  void note(const RobotPose& told);
  bool driving() const;

  std::optional<std::int8_t> phase_;
  std::optional<SimBaseTruth> last_;
  std::deque<SimBaseTruth> recent_;  // what a ROBOT_POSE may answer
  std::vector<Pose2> true_way_, told_way_;
  int drives_ = 0;
  double seconds_ = 0.0;
  double way_ = 0.0;
  double strayed_ = 0.0;
  std::optional<double> rest_since_way_;
  bool touched_ = false;
  std::optional<double> nearest_;
  std::optional<SimBaseTruth> arrived_;  // when the first drive had ended
  PoseError told_error_, told_error_arrived_;
  std::vector<double> told_errors_;  // m, in drives
};

// True if it drove to within a dock's reach of the goal, touched nothing, and stood while the arm worked.
bool truly_driven(const DriveResult& drive);

// For report.json.
nlohmann::json report_of(const DriveResult& drive, const Pose2& goal);

// For people: some lines, each ended.
std::string words_of(const DriveResult& drive);

}  // namespace markservo::experiments
