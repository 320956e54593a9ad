#pragma once

// What the hand holds, as far as it is known.

#include <cstdint>
#include <optional>

#include "services/task-manager/procedure_types.hpp"

namespace markservo::task_manager {

class Holding {
 public:
  bool something() const { return something_; }
  // Lifted straight from where it stood: it can be put back.
  bool over_place() const { return something_ && over_place_; }

  // The hand has closed around an object of this width (m) at its place.
  void grip(const ArmReport& arm, double object_width);
  // The object leaves its place for good.
  void carry_away() { over_place_ = false; }
  // The hand has opened and gone.
  void release() { something_ = false; }
  // The gripper is commanded to this opening (m).
  void observe_command(double opening);

  // The hand still holds it: it was not told to let go, and the arm's report does not speak against it.
  bool holds_on(const std::optional<ArmReport>& arm) const;

  // True when what was held is not held any more: a reset simulator or a person may have taken it away. `at_work`: the
  // arm moves with it, so that it may be anywhere.
  bool loses(const std::optional<ArmReport>& arm, bool at_work);

 private:
  bool too_wide(const ArmReport& arm) const;

  bool something_ = false;
  bool over_place_ = false;
  bool let_go_ = false;        // the hand was told to open: whether it still holds is not known
  double object_width_ = 0.0;  // m
  std::int64_t arm_session_ = 0;
  robot::JointVector q_ = robot::JointVector::Zero();  // rad, when the arm last moved for a task
};

}  // namespace markservo::task_manager
