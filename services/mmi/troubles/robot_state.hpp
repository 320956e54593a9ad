#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "services/mmi/troubles/words.hpp"

namespace markservo::mmi {

// The newest of what the robot said of itself, for the status line and /state.json. Nothing where nothing was heard.
class RobotState {
 public:
  void observe(const TaskWord& word);
  void observe(const ServoWord& word) { servo_ = word; }
  void observe(const BaseWord& word) { base_ = word; }
  void observe(const PoseWord& word) { pose_ = word; }
  // One that records counts before one that does not.
  void observe(const RecorderWord& word);

  const std::optional<TaskWord>& task() const { return task_; }
  // us of the source's clock: when the task was first heard to be in its phase.
  std::int64_t task_since_utime() const { return task_since_utime_; }
  const std::optional<ServoWord>& servo() const { return servo_; }
  const std::optional<BaseWord>& base() const { return base_; }
  const std::optional<PoseWord>& pose() const { return pose_; }
  const std::optional<RecorderWord>& recorder() const { return recorder_; }

  // What the robot does now, in one short sentence: "SERVO: red_book, 3.2 mm to go", "DRIVE: 0.8 m to go", "idle".
  std::string activity() const;

 private:
  std::optional<TaskWord> task_;
  std::int64_t task_since_utime_ = 0;
  std::optional<ServoWord> servo_;
  std::optional<BaseWord> base_;
  std::optional<PoseWord> pose_;
  std::optional<RecorderWord> recorder_;
};

}  // namespace markservo::mmi
