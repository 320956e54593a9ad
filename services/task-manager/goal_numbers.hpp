#pragma once

// Under which id the next goal goes out: above our last one, and above one that another sent in our name, which its
// mover now takes for our last. A report that alternates with the mover's own counts for nothing.

#include <algorithm>
#include <cstdint>

#include "common/motion/goal_inbox.hpp"
#include "common/time/seconds_between.hpp"

namespace markservo::task_manager {

class GoalNumbers {
 public:
  // The mover reports at `utime` (us) that it follows our goal `id`; 0: none of ours.
  void observe(std::int64_t id, std::int64_t utime) {
    if (id != reported_ || utime < since_) since_ = utime;
    reported_ = id;
    if (seconds_between(since_, utime) < kSteady_s || id > kLargest) return;
    taken_ = std::max(taken_, id);
  }

  // The id after `last`, which was ours.
  std::int64_t next(std::int64_t last) const { return std::max(last, taken_) + 1; }

 private:
  static constexpr double kSteady_s = 0.5;  // so long a mover says so and nothing else
  // Far above what inboxes take for a first id, so that whatever they took can be passed.
  static constexpr std::int64_t kLargest = 2 * motion::kLargestFirstId;

  std::int64_t reported_ = 0;
  std::int64_t since_ = 0;  // us, that it has been reported without another between
  std::int64_t taken_ = 0;  // largest id that counts as sent in our name
};

}  // namespace markservo::task_manager
