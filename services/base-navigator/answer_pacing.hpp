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
  // Which one must be answered before this odometry, if one is still open.
  std::optional<OdometryId> observe_odometry(const OdometryId& odometry) {
    const std::optional<OdometryId> overdue = open_;
    open_ = odometry;
    return overdue;
  }

  // The newest pose answers that one.
  void observe_pose(const OdometryId& pose) { pose_ = pose; }

  // Whether the open odometry is to be answered now; it is not open any more then. `longest_wait` (s) is the age of the
  // newest pose from which on the next one is not waited for.
  std::optional<OdometryId> due(double longest_wait) {
    if (!open_) return std::nullopt;
    const bool waits = pose_ && !same(*pose_, *open_) && seconds_between(pose_->utime, open_->utime) <= longest_wait;
    if (waits) return std::nullopt;
    const std::optional<OdometryId> now = open_;
    open_.reset();
    return now;
  }

 private:
  std::optional<OdometryId> open_;
  std::optional<OdometryId> pose_;
};

}  // namespace markservo::base_navigator
