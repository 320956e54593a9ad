#pragma once

// What the page's views and its list of events take of the bus's messages, as plain structs. The robot's frames are
// config/robot.yaml's: C the cameras', R the robot's, W the tag field's.

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "common/geometry/plane_pose.hpp"
#include "common/robot/robot_description.hpp"
#include "common/states/base_state.hpp"
#include "common/states/localisation_state.hpp"
#include "common/states/mark_cue.hpp"
#include "common/states/mark_status.hpp"
#include "common/states/servo_state.hpp"
#include "common/states/task_phase.hpp"

namespace markservo::mmi {

// JOINT_STATE or JOINT_COMMAND.
struct JointReport {
  bool commanded = false;
  std::int64_t utime = 0;  // us
  robot::JointVector q = robot::JointVector::Zero();
};

struct MarkReport {
  std::string name;
  robot::MarkRole role = robot::MarkRole::kTarget;
  MarkStatus status = MarkStatus::kUnseen;
  MarkCue cue = MarkCue::kNone;
  Eigen::Vector3d p_C = Eigen::Vector3d::Zero();           // m; holds when located
  Eigen::Matrix3d covariance_C = Eigen::Matrix3d::Zero();  // m^2, of p_C
  Eigen::Vector3d normal_C = Eigen::Vector3d::Zero();      // unit vector; zero when no plane carries p_C
};

// TARGET_POSE.
struct TargetReport {
  std::int64_t utime = 0;  // us, the frame's
  std::int64_t frame_seq = 0;
  std::vector<MarkReport> marks;
};

// SERVO_GOAL.
struct ServoGoalReport {
  bool by_sight = false;                             // SERVO; else HOLD or POSTURE, and the rest says nothing
  std::string target;                                // the mark's name
  Eigen::Vector3d p_TG_C = Eigen::Vector3d::Zero();  // m, wanted grip point from the target mark's centre, axes of C
};

struct TagHit {
  std::string uid;
  std::int64_t utime = 0;      // us, when the host heard of it
  std::optional<double> rssi;  // dBm
};

// RFID_TAG_HITS.
struct RoundReport {
  std::int64_t utime = 0;  // us, when the host had the answer
  std::vector<TagHit> hits;
};

// ROBOT_POSE.
struct PoseReport {
  std::int64_t utime = 0;  // us
  std::int64_t session = 0;
  LocalisationState state = LocalisationState::kSearching;
  geometry::PlanePose X_WR;  // holds when localised
  double delay = 0.0;        // s, estimated, from the middle of a round to its arrival
  std::string reason;
};

// TASK_STATE.
struct TaskReport {
  std::int64_t session = 0;
  TaskPhase phase = TaskPhase::kIdle;
  int attempt = 0;
  std::string target;
  std::string reason;
};

// SERVO_STATUS.
struct ServoReport {
  std::int64_t session = 0;
  ServoState state = ServoState::kHold;
  bool settled = false;
  std::string reason;
};

// BASE_STATUS.
struct BaseReport {
  std::int64_t session = 0;
  BaseState state = BaseState::kHold;
  std::string reason;
};

// STOP_STATE.
struct StopReport {
  std::int64_t session = 0;
  std::string device;
  bool latched = false;
  std::int64_t request_session = 0;  // the last request obeyed; 0: none
  std::int64_t request_id = 0;
  std::string reason;
};

// STOP.
struct StopRequestReport {
  std::int64_t session = 0;
  std::int64_t request_id = 0;
  bool reset = false;  // else STOP
  std::string source;
  std::string reason;
};

enum class CommandKind { kStart, kAbort, kHome, kDrive };  // as TaskCommand.lcm numbers them

// TASK_COMMAND.
struct CommandReport {
  std::int64_t session = 0;
  std::int64_t command_id = 0;
  CommandKind kind = CommandKind::kAbort;
  std::string target;  // START
  bool carry = false;  // START
  bool drive = false;  // START: drive there first
};

// SERVICE_STATUS.
struct ServiceReport {
  std::int64_t session = 0;
  std::string name;
  std::string host;
  std::string state;
  std::string reason;
};

// As ProcessStatus.lcm numbers them.
enum class ProcessState { kStopped, kStarting, kRunning, kSilent, kWaiting, kEnded, kFailed };

// PROCESS_STATUS.
struct ProcessReport {
  std::int64_t session = 0;
  std::string name;
  std::string host;
  ProcessState state = ProcessState::kStopped;
  int restarts = 0;
  std::string why;
};

// RECORDER_STATUS.
struct RecorderReport {
  std::int64_t session = 0;
  std::string folder;
  std::string host;
  bool recording = false;
  int parts = 0;
  std::string why;
};

// One message; nothing where no view takes any of it.
using Report = std::variant<std::monostate, JointReport, TargetReport, ServoGoalReport, RoundReport, PoseReport,
                            TaskReport, ServoReport, BaseReport, StopReport, StopRequestReport, CommandReport,
                            ServiceReport, ProcessReport, RecorderReport>;

}  // namespace markservo::mmi
