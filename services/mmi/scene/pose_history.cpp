#include "services/mmi/scene/pose_history.hpp"

#include <algorithm>

#include "common/time/seconds_between.hpp"

namespace markservo::mmi {
namespace {

// X_WR the given share of the way from one pose to the other, turning the shorter way.
geometry::PlanePose between(const geometry::PlanePose& from, const geometry::PlanePose& to, double share) {
  return {from.x + share * (to.x - from.x), from.y + share * (to.y - from.y),
          geometry::wrapped(from.heading + share * geometry::wrapped(to.heading - from.heading))};
}

}  // namespace

void PoseHistory::add(const PoseReport& pose) {
  if (!poses_.empty() && (pose.session != poses_.back().session || pose.utime < poses_.back().utime)) poses_.clear();
  if (!poses_.empty() && pose.utime == poses_.back().utime) poses_.pop_back();
  poses_.push_back(pose);
  poses_.back().reason.clear();
  while (poses_.size() > parameters_.most || seconds_between(poses_.front().utime, pose.utime) > parameters_.kept) {
    poses_.pop_front();
  }
}

std::optional<geometry::PlanePose> PoseHistory::at(std::int64_t utime) const {
  const auto localised = [](const PoseReport& pose) { return pose.state == LocalisationState::kLocalised; };
  const auto after = std::lower_bound(poses_.begin(), poses_.end(), utime,
                                      [](const PoseReport& pose, std::int64_t time) { return pose.utime < time; });
  if (after != poses_.end() && after->utime == utime) {
    return localised(*after) ? std::optional(after->X_WR) : std::nullopt;
  }
  if (after == poses_.begin()) return std::nullopt;
  const PoseReport& before = *std::prev(after);
  const double since = seconds_between(before.utime, utime);
  if (!localised(before)) return std::nullopt;
  if (after == poses_.end()) return since <= parameters_.hold_max ? std::optional(before.X_WR) : std::nullopt;
  const double gap = seconds_between(before.utime, after->utime);
  if (gap > parameters_.gap_max || !localised(*after)) return std::nullopt;
  return between(before.X_WR, after->X_WR, since / gap);
}

std::optional<double> PoseHistory::delay() const {
  if (poses_.empty()) return std::nullopt;
  return poses_.back().delay;
}

}  // namespace markservo::mmi
