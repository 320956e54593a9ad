#pragma once

// What was heard of the robot, as plain structs: all that tells of troubles and of what the robot does now. `at` is
// when it was heard: us of the source's clock, which is the wall clock live and the log's time in a log.

#include <cstdint>
#include <string>
#include <vector>

#include "common/geometry/plane_pose.hpp"
#include "common/states/base_state.hpp"
#include "common/states/localisation_state.hpp"
#include "common/states/mark_status.hpp"
#include "common/states/servo_state.hpp"
#include "common/states/task_phase.hpp"
#include "services/mmi/scene/reports.hpp"

namespace markservo::mmi {

// Any message, of any channel of the table.
struct AnyWord {
  std::int64_t at = 0;
  std::string channel;       // without a robot's prefix
  std::string writer_of;     // which of the channel's writers shall be one alone: "", or a stop device
  bool one_writes = false;   // a second writer of the same is a fault
  std::int64_t session = 0;  // of the writer
  std::int64_t utime = 0;    // us, the message's own
};

// TASK_STATE.
struct TaskWord {
  std::int64_t at = 0;
  TaskPhase phase = TaskPhase::kIdle;
  TaskResult result = TaskResult::kNone;
  std::string target;
  std::string reason;
};

// SERVO_STATUS.
struct ServoWord {
  std::int64_t at = 0;
  ServoState state = ServoState::kHold;
  bool settled = false;
  double error = 0.0;  // m, of the grip point from its goal; 0 while unknown
  std::string reason;
};

// BASE_STATUS.
struct BaseWord {
  std::int64_t at = 0;
  BaseState state = BaseState::kHold;
  double distance = 0.0;  // m, to the goal; 0 while unknown
  std::string reason;
};

// ROBOT_POSE.
struct PoseWord {
  std::int64_t at = 0;
  LocalisationState state = LocalisationState::kSearching;
  geometry::PlanePose X_WR;
  double sigma_x = 0.0;  // m
  double sigma_y = 0.0;  // m
  std::string reason;
};

// STOP_STATE.
struct StopWord {
  std::int64_t at = 0;
  std::string device;
  bool latched = false;
  bool obeyed_a_request = false;  // any, since it came up
  std::string reason;
};

struct MarkWord {
  std::string name;
  bool is_hand = false;  // role manipulator
  MarkStatus status = MarkStatus::kUnseen;
};

// TARGET_POSE.
struct MarksWord {
  std::int64_t at = 0;
  std::vector<MarkWord> marks;
};

// What a service has received on one channel since its start.
struct ReceivedWord {
  std::string channel;  // without a robot's prefix
  std::int64_t received = 0;
  std::int64_t lost = 0;
  std::int64_t refused = 0;
  bool second_writer = false;
};

// SERVICE_STATUS.
struct ServiceWord {
  std::int64_t at = 0;
  std::int64_t session = 0;
  std::string name;
  std::string host;
  int pid = 0;
  std::string state;
  std::string reason;
  std::vector<ReceivedWord> channels;
};

// PROCESS_STATUS.
struct ProcessWord {
  std::int64_t at = 0;
  std::string name;
  std::string host;
  ProcessState state = ProcessState::kStopped;
  int pid = 0;
  std::string why;
};

// RECORDER_STATUS.
struct RecorderWord {
  std::int64_t at = 0;
  std::string folder;
  std::string host;
  bool recording = false;
  std::int64_t bytes = 0;
  std::int64_t free_bytes = 0;
  int parts = 0;
  std::string why;
};

}  // namespace markservo::mmi
