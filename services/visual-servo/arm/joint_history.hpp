#pragma once

// The last second of joint states, to be asked where the arm was at a frame's exposure, since when it rests, and
// where in their play its shafts lie, however long ago they were turned.

#include <cstdint>
#include <deque>
#include <optional>

#include "services/visual-servo/servo_types.hpp"

namespace markservo::visual_servo {

class JointHistory {
 public:
  // Adds a sample; one that is not newer than the newest is passed over. A gap of more than 0.3 s, or a leap that no
  // servo can make (`max_speed`, rad/s per joint), starts the history anew and returns true: what was commanded before
  // no longer holds. `play`: rad, by which shafts trail behind a joint that turns on, as far as that is known.
  bool add(const JointSample& sample, const JointVector& max_speed, double play = 0.0);

  void forget() { entries_.clear(); }

  bool empty() const { return entries_.empty(); }
  const JointSample& newest() const { return entries_.back().sample; }

  // Joint positions at `utime`, interpolated; the oldest sample's before the history, up to 10 ms of the present motion
  // added after it. Requires !empty().
  JointVector at(std::int64_t utime) const;

  // How fast the joints came to where they were at `utime`, rad/s. Requires !empty().
  JointVector speed(std::int64_t utime) const;

  // Where in its play each shaft lay at `utime`: 1 where it trails wholly behind a joint that turned to larger angles,
  // -1 to smaller ones, between them where the joint has turned back by less than twice its play; 0 where it has not
  // turned since the history began. Requires !empty().
  const JointVector& trailing(std::int64_t utime) const;

  // The first utime since which every sample has been within `tolerance` (rad) of `position`; nothing when the newest
  // is not. Requires !empty().
  std::optional<std::int64_t> near_since(const JointVector& position, double tolerance) const;

 private:
  struct Entry {
    JointSample sample;
    JointVector trailing;
  };
  using Entries = std::deque<Entry>;

  Entries::const_iterator first_from(std::int64_t utime) const;
  JointVector extrapolated(std::int64_t utime) const;

  Entries entries_;
};

}  // namespace markservo::visual_servo
