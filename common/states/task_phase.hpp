#pragma once

// The phases of a task, for those who run it and those who ask for it.

namespace markservo {

// As TaskState.lcm numbers them.
enum class TaskPhase {
  kIdle,
  kLook,
  kApproach,
  kServo,
  kGrip,
  kLift,
  kVerify,
  kLiftOn,
  kCarry,
  kRelease,
  kGoHome,
  kHoldLifted,
  kDone,
  kRefused,
  kFailed,
  kStopped,
  kDrive,
};

// What became of the last task, as TaskState.lcm numbers it.
enum class TaskResult { kNone, kLifted, kRefused, kFailed };

// A word for a person: "look", "lift on", "lifted", ... Throws std::out_of_range if it is none of them.
const char* name_of(TaskPhase phase);

// True while a task or a way home is under way.
bool under_way(TaskPhase phase);

}  // namespace markservo
