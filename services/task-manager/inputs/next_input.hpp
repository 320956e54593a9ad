#pragma once

// What has come for the next step.

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "services/task-manager/inputs/base_reports.hpp"
#include "services/task-manager/inputs/command_queue.hpp"
#include "services/task-manager/procedure_types.hpp"

namespace markservo::task_manager {

class NextInput {
 public:
  void observe(const Command& command) { commands_.add(command); }
  void observe(const BaseReport& report) { base_.add(report); }
  void observe(const ArmReport& report) { input_.arm = report; }
  // `pose_utime`: us, TARGET_POSE's.
  void observe(std::int64_t pose_utime, std::vector<MarkReport> marks) {
    input_.pose_utime = pose_utime;
    input_.marks = std::move(marks);
  }

  // A report of another arm than the one that is believed; it may take that one's place.
  void observe_stranger(const ArmReport& report) { stranger_ = report; }
  // The arm's session is another one from now on. `told`: the arm was told something by what was reported. What another
  // said before anyone was known tells nothing of what the hand holds.
  void replace_arm(std::int64_t session, bool told) {
    if (stranger_ && stranger_->session == session) {
      input_.arm = stranger_;
    } else if (!told) {
      input_.arm.reset();
    }
  }

  // The input of the step at a SERVO_STATUS. `utime`: us, the frame's; `now`: us, the arm's.
  Input take(const ServoReport& servo, const StopReport& stop, std::int64_t utime, std::int64_t now) {
    input_.servo = servo;
    input_.stop = stop;
    input_.utime = utime;
    input_.now = now;
    input_.base = base_.before(utime);
    input_.commands = commands_.take();
    return input_;
  }

 private:
  Input input_;
  BaseReports base_;
  CommandQueue commands_;
  std::optional<ArmReport> stranger_;
};

}  // namespace markservo::task_manager
