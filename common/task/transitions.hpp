#pragma once

// The procedure of a task (paper fig. 11) as a table: from which phase to which, and when. Who runs a task keeps to it,
// who draws one draws it.
//
//   IDLE -> LOOK -> APPROACH -> SERVO -> GRIP -> LIFT -> VERIFY -> LIFT_ON -> HOLD_LIFTED
//             |                    ^                        |          '-> CARRY -> RELEASE -> GO_HOME -> DONE
//             v                    '-- LOOK <- RELEASE <----'  once, when the object did not come along
//          REFUSED               any -> FAILED; STOP or ABORT: any -> STOPPED
//
// A task with a pose to drive to begins with DRIVE: the arm folds, the base drives, the robot stands a moment. When
// LOOK then finds the target where it cannot be taken, DRIVE brings the robot nearer, a few times. In every other
// phase, and without a task, the base is told to hold.
//
// Commands: each is executed once, START and HOME only while fresh by the arm's time. START and HOME while a task is
// under way are answered and ignored; ABORT ends any task where the arm is. HOME with an object held over its place
// puts it back first; START is refused while the hand holds one. After STOP a new START is needed.

#include "common/states/task_phase.hpp"

namespace markservo {

struct TaskTransition {
  TaskPhase from;
  TaskPhase to;
  const char* when;  // a few words for people
};

inline constexpr TaskTransition kTaskTransitions[] = {
    // Figure 11, and the drive before it.
    {TaskPhase::kDrive, TaskPhase::kLook, "arrived"},
    {TaskPhase::kDrive, TaskPhase::kDone, "arrived: there was nothing to take"},
    {TaskPhase::kDrive, TaskPhase::kRefused, "it cannot set off"},
    {TaskPhase::kLook, TaskPhase::kDrive, "cannot be taken from here: nearer"},
    {TaskPhase::kLook, TaskPhase::kRefused, "cannot be taken"},
    {TaskPhase::kLook, TaskPhase::kApproach, "can be taken"},
    {TaskPhase::kApproach, TaskPhase::kServo, "the hand is seen"},
    {TaskPhase::kApproach, TaskPhase::kRelease, "the hand is not seen: back off"},
    {TaskPhase::kServo, TaskPhase::kGrip, "at the grip point"},
    {TaskPhase::kServo, TaskPhase::kRelease, "lost, late or out of reach: back off"},
    {TaskPhase::kGrip, TaskPhase::kLift, "closed, both marks measured"},
    {TaskPhase::kGrip, TaskPhase::kRelease, "a mark is not seen: let go"},
    {TaskPhase::kLift, TaskPhase::kVerify, "lifted a little"},
    {TaskPhase::kVerify, TaskPhase::kLiftOn, "it came along"},
    {TaskPhase::kVerify, TaskPhase::kRelease, "it did not: let go"},
    {TaskPhase::kLiftOn, TaskPhase::kHoldLifted, "lifted"},
    {TaskPhase::kLiftOn, TaskPhase::kCarry, "lifted, to be carried"},
    {TaskPhase::kCarry, TaskPhase::kRelease, "over the side table"},
    {TaskPhase::kRelease, TaskPhase::kLook, "once more"},
    {TaskPhase::kRelease, TaskPhase::kGoHome, "let go"},
    {TaskPhase::kGoHome, TaskPhase::kDone, "home"},

    // Tried, and given up.
    {TaskPhase::kDrive, TaskPhase::kFailed, "does not arrive"},
    {TaskPhase::kLook, TaskPhase::kFailed, "cannot be taken, after a drive or a grip"},
    {TaskPhase::kApproach, TaskPhase::kFailed, "no answer, or no way"},
    {TaskPhase::kServo, TaskPhase::kFailed, "no answer, or no way"},
    {TaskPhase::kGrip, TaskPhase::kFailed, "no answer, or no way"},
    {TaskPhase::kLift, TaskPhase::kFailed, "no answer, or no way"},
    {TaskPhase::kVerify, TaskPhase::kFailed, "no answer, or no way"},
    {TaskPhase::kLiftOn, TaskPhase::kFailed, "no answer, or no way"},
    {TaskPhase::kCarry, TaskPhase::kFailed, "no answer, or no way"},
    {TaskPhase::kRelease, TaskPhase::kFailed, "backed off, or no answer"},
    {TaskPhase::kGoHome, TaskPhase::kFailed, "no answer, or no way"},

    // By a person, or for what may not be gone on with: a stop device is silent, the arm restarted.
    {TaskPhase::kDrive, TaskPhase::kStopped, "STOP or ABORT"},
    {TaskPhase::kLook, TaskPhase::kStopped, "STOP or ABORT"},
    {TaskPhase::kApproach, TaskPhase::kStopped, "STOP or ABORT"},
    {TaskPhase::kServo, TaskPhase::kStopped, "STOP or ABORT"},
    {TaskPhase::kGrip, TaskPhase::kStopped, "STOP or ABORT"},
    {TaskPhase::kLift, TaskPhase::kStopped, "STOP or ABORT"},
    {TaskPhase::kVerify, TaskPhase::kStopped, "STOP or ABORT"},
    {TaskPhase::kLiftOn, TaskPhase::kStopped, "STOP or ABORT"},
    {TaskPhase::kCarry, TaskPhase::kStopped, "STOP or ABORT"},
    {TaskPhase::kRelease, TaskPhase::kStopped, "STOP or ABORT"},
    {TaskPhase::kGoHome, TaskPhase::kStopped, "STOP or ABORT"},
    {TaskPhase::kHoldLifted, TaskPhase::kStopped, "STOP, or nothing is held"},

    // START.
    {TaskPhase::kIdle, TaskPhase::kDrive, "DRIVE, or START with a drive"},
    {TaskPhase::kDone, TaskPhase::kDrive, "DRIVE, or START with a drive"},
    {TaskPhase::kRefused, TaskPhase::kDrive, "DRIVE, or START with a drive"},
    {TaskPhase::kFailed, TaskPhase::kDrive, "DRIVE, or START with a drive"},
    {TaskPhase::kStopped, TaskPhase::kDrive, "DRIVE, or START with a drive"},
    {TaskPhase::kIdle, TaskPhase::kLook, "START"},
    {TaskPhase::kDone, TaskPhase::kLook, "START"},
    {TaskPhase::kRefused, TaskPhase::kLook, "START"},
    {TaskPhase::kFailed, TaskPhase::kLook, "START"},
    {TaskPhase::kStopped, TaskPhase::kLook, "START"},
    {TaskPhase::kIdle, TaskPhase::kRefused, "START or DRIVE that cannot be done"},
    {TaskPhase::kDone, TaskPhase::kRefused, "START or DRIVE that cannot be done"},
    {TaskPhase::kFailed, TaskPhase::kRefused, "START or DRIVE that cannot be done"},
    {TaskPhase::kStopped, TaskPhase::kRefused, "START or DRIVE that cannot be done"},
    {TaskPhase::kHoldLifted, TaskPhase::kRefused, "START or DRIVE with a full hand"},

    // HOME.
    {TaskPhase::kHoldLifted, TaskPhase::kRelease, "HOME: put back first"},
    {TaskPhase::kRefused, TaskPhase::kRelease, "HOME: put back first"},
    {TaskPhase::kFailed, TaskPhase::kRelease, "HOME: put back first"},
    {TaskPhase::kStopped, TaskPhase::kRelease, "HOME: put back first"},
    {TaskPhase::kIdle, TaskPhase::kGoHome, "HOME"},
    {TaskPhase::kDone, TaskPhase::kGoHome, "HOME"},
    {TaskPhase::kRefused, TaskPhase::kGoHome, "HOME"},
    {TaskPhase::kFailed, TaskPhase::kGoHome, "HOME"},
    {TaskPhase::kStopped, TaskPhase::kGoHome, "HOME"},
    {TaskPhase::kIdle, TaskPhase::kStopped, "HOME that may not be"},
    {TaskPhase::kDone, TaskPhase::kStopped, "HOME that may not be"},
    {TaskPhase::kRefused, TaskPhase::kStopped, "HOME that may not be"},
    {TaskPhase::kFailed, TaskPhase::kStopped, "HOME that may not be"},
    {TaskPhase::kIdle, TaskPhase::kFailed, "HOME without a way"},
    {TaskPhase::kDone, TaskPhase::kFailed, "HOME without a way"},
    {TaskPhase::kRefused, TaskPhase::kFailed, "HOME without a way"},
    {TaskPhase::kStopped, TaskPhase::kFailed, "HOME without a way"},
    {TaskPhase::kHoldLifted, TaskPhase::kFailed, "HOME without a way"},
};

// Whether the table has it. What rests may enter its phase anew, which is no transition.
constexpr bool may_follow(TaskPhase from, TaskPhase to) {
  for (const TaskTransition& transition : kTaskTransitions) {
    if (transition.from == from && transition.to == to) return true;
  }
  return false;
}

}  // namespace markservo
