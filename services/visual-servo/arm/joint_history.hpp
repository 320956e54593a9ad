#pragma once

// The last second of joint states, to be asked where the arm was at a frame's exposure and since when it rests.

#include <cstdint>
#include <deque>
#include <optional>

#include "services/visual-servo/servo_types.hpp"

namespace markservo::visual_servo {

class JointHistory {
 public:
  // Adds a sample; one that is not newer than the newest is passed over. A gap of more than 0.3 s, or a leap that no
  // servo can make (`max_speed`, rad/s per joint), starts the history anew and returns true: what was commanded before
  // no longer holds.
  bool add(const JointSample& sample, const JointVector& max_speed);

  void forget() { samples_.clear(); }

  bool empty() const { return samples_.empty(); }
  const JointSample& newest() const { return samples_.back(); }

  // Joint positions at `utime`, interpolated; the oldest sample's before the history, up to 10 ms of the present motion
  // added after it. Requires !empty().
  JointVector at(std::int64_t utime) const;

  // How fast the joints came to where they were at `utime`, rad/s. Requires !empty().
  JointVector speed(std::int64_t utime) const;

  // The direction, -1 or 1, in which each joint moved last until `utime`; 0 where it rested for as long as the history
  // goes back. Requires !empty().
  JointVector directions(std::int64_t utime) const;

  // The first utime since which every sample has been within `tolerance` (rad) of `position`; nothing when the newest
  // is not. Requires !empty().
  std::optional<std::int64_t> near_since(const JointVector& position, double tolerance) const;

 private:
  JointVector extrapolated(std::int64_t utime) const;

  std::deque<JointSample> samples_;
};

}  // namespace markservo::visual_servo
