#pragma once

#include <cstdint>
#include <optional>

#include "services/base-navigator/navigator_types.hpp"

namespace markservo::base_navigator {

// Which WHEEL_ODOMETRY a message is, or answers.
struct OdometryId {
  std::int64_t utime = 0;
  std::int64_t session = 0;
  std::int64_t seq = 0;
};

inline bool same(const OdometryId& a, const OdometryId& b) {
  return a.session == b.session && a.seq == b.seq;
}

// When each WHEEL_ODOMETRY is answered: by the ROBOT_POSE that answers it too, else before the next odometry, at once
// while poses stay away. So each is answered exactly once, live and from a log.
class AnswerPacing {
 public:
  // An odometry came in: which one must be answered before it, if one is still open.
  std::optional<OdometryId> next(const OdometryId& odometry) {
    const std::optional<OdometryId> overdue = open_;
    open_ = odometry;
    return overdue;
  }

  // Whether the open odometry is to be answered now; it is not open any more then. `pose` is the newest one's identity,
  // `longest_wait` (s) the age from which on the next pose is not waited for.
  std::optional<OdometryId> due(const std::optional<OdometryId>& pose, double longest_wait) {
    if (!open_) return std::nullopt;
    const bool waits = pose && !same(*pose, *open_) && seconds_between(pose->utime, open_->utime) <= longest_wait;
    if (waits) return std::nullopt;
    const std::optional<OdometryId> now = open_;
    open_.reset();
    return now;
  }

  // The odometry was refused: nothing answers it.
  void drop() { open_.reset(); }

 private:
  std::optional<OdometryId> open_;
};

}  // namespace markservo::base_navigator
