#pragma once

// The goal that is followed: which of those heard, why it is not, and where it lies.

#include <optional>
#include <string>

#include "common/geometry/plane_pose.hpp"
#include "common/motion/goal_inbox.hpp"
#include "services/base-navigator/inputs/trust.hpp"
#include "services/base-navigator/kinematics/odometry_track.hpp"
#include "services/base-navigator/navigator_types.hpp"

namespace markservo::base_navigator {

class FollowedGoal {
 public:
  // What became of a goal, new or repeated, heard while the stop is `latched` or not.
  motion::GoalHeard observe(const TrustParameters& trust, const Goal& goal, const OdometryTrack& track, bool latched);
  // To be called at the first odometry: ends a goal that came before any time, unless it is fresh now, so that none
  // waits for its hour.
  void end_unless_fresh(const TrustParameters& trust, const OdometryTrack& track);

  // Ends the goal, at a stop: it will not be taken up again.
  void end();
  // Ends it likewise at another beginning, `why` for people: why_none() says so until the next one.
  void drop(const std::string& why);

  const std::optional<Goal>& goal() const { return goal_; }
  // Why the goal is not followed; empty when it is.
  const std::string& refusal() const { return refusal_; }
  // Why there is no goal.
  std::string why_none() const { return dropped_.empty() ? "no goal" : dropped_; }

  // X_WG of a DRIVE goal. One in R is kept in the wheels' frame until there is a pose X_WR of now to place it by;
  // nothing, with a refusal(), where the wheels' frame has become another before.
  std::optional<geometry::PlanePose> place(const geometry::PlanePose& X_WR, const OdometryTrack& track);

  const motion::GoalInbox& inbox() const { return inbox_; }

 private:
  motion::GoalInbox inbox_{"BASE_GOAL"};
  std::optional<Goal> goal_;  // what inbox_.goal() asks for
  std::string refusal_;
  std::string dropped_;
  std::optional<geometry::PlanePose> X_WG_;  // once known
  std::optional<geometry::PlanePose> X_OG_;  // of a goal in R
  int X_OG_epoch_ = 0;
};

}  // namespace markservo::base_navigator
