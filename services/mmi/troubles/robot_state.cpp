#include "services/mmi/troubles/robot_state.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cctype>

namespace markservo::mmi {
namespace {

std::string in_capitals(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char letter) { return static_cast<char>(std::toupper(letter)); });
  return text;
}

std::string joined(const std::string& begin, const std::string& rest) {
  return rest.empty() ? begin : begin + ": " + rest;
}

std::string of_both(const std::string& a, const std::string& b) {
  return a.empty() || b.empty() ? a + b : a + ", " + b;
}

// How far the arm has come by sight; empty where that is not known.
std::string servo_progress(const ServoWord& servo) {
  if (servo.state == ServoState::kServo || servo.state == ServoState::kConverged) {
    return servo.error > 0.0 ? fmt::format("{:.1f} mm to go", 1e3 * servo.error) : "";
  }
  if (servo.state == ServoState::kHold || servo.state == ServoState::kPosture) return "";
  return joined("holds", servo.reason.empty() ? name_of(servo.state) : servo.reason);
}

std::string base_progress(const BaseWord& base) {
  switch (base.state) {
    case BaseState::kDriving:
      return base.distance > 0.0 ? fmt::format("{:.1f} m to go", base.distance) : "";
    case BaseState::kArrived:
      return "arrived";
    case BaseState::kHold:
      return base.reason;
    case BaseState::kBlocked:
    case BaseState::kLost:
    case BaseState::kStale:
    case BaseState::kStopped:
      break;
  }
  return joined(std::string("stands, ") + name_of(base.state), base.reason);
}

std::string of_task(const TaskWord& task, const std::optional<ServoWord>& servo, const std::optional<BaseWord>& base) {
  const std::string phase = in_capitals(name_of(task.phase));
  switch (task.phase) {
    case TaskPhase::kIdle:
      return "idle";
    case TaskPhase::kDone:
      return joined("done", task.target);
    case TaskPhase::kHoldLifted:
      return joined("lifted", task.target);
    case TaskPhase::kDrive:
      if (const std::string progress = base ? base_progress(*base) : ""; !progress.empty()) {
        return joined(phase, progress);
      }
      return joined(phase, task.reason);
    case TaskPhase::kServo:
      return joined(phase, of_both(task.target, servo ? servo_progress(*servo) : ""));
    case TaskPhase::kRefused:
    case TaskPhase::kFailed:
    case TaskPhase::kStopped:
      return joined(phase, of_both(task.target, task.reason));
    default:
      return joined(phase, task.reason.empty() ? task.target : task.reason);
  }
}

}  // namespace

void RobotState::observe(const TaskWord& word) {
  if (!task_ || task_->phase != word.phase) task_since_utime_ = word.at;
  task_ = word;
}

void RobotState::observe(const RecorderWord& word) {
  const bool another = recorder_ && (recorder_->folder != word.folder || recorder_->host != word.host);
  if (another && recorder_->recording && !word.recording) return;
  recorder_ = word;
}

std::string RobotState::activity() const {
  if (task_) return of_task(*task_, servo_, base_);
  if (base_ && base_->state == BaseState::kDriving) return joined("DRIVE", base_progress(*base_));
  if (servo_ && servo_->state == ServoState::kServo) return joined("SERVO", servo_progress(*servo_));
  if (servo_ || base_) return "no task is told of: task-manager is not heard";
  return "nothing is heard of a robot";
}

}  // namespace markservo::mmi
