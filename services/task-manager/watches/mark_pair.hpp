#pragma once

// Where the object's mark and the hand's are, averaged over the frames that show both.

#include <cstdint>

#include "services/task-manager/procedure_types.hpp"
#include "services/task-manager/watches/lift_check.hpp"

namespace markservo::task_manager {

class MarkPair {
 public:
  // A frame, by its utime (us); each counts once.
  void observe(std::int64_t frame_utime, const MarkReport& target, const MarkReport& hand) {
    if (target.sight != Sight::kLocated || hand.sight != Sight::kLocated) return;
    target_.add(frame_utime, target.p_C);
    hand_.add(frame_utime, hand.p_C);
  }
  int count() const { return target_.count(); }
  // Both marks' mean places, with the arm at `q` (rad).
  LiftView view(const robot::JointVector& q) const { return {target_.mean(), hand_.mean(), q}; }

 private:
  MarkAverage target_;
  MarkAverage hand_;
};

}  // namespace markservo::task_manager
