#include "services/base-navigator/drive/path_guard.hpp"

#include <algorithm>
#include <cmath>

#include "services/base-navigator/kinematics/speed_profile.hpp"

namespace markservo::base_navigator {
namespace {

constexpr double kPathStep_m = 0.03;
constexpr double kBeyondStop_m = 0.3;  // of path that is looked at beyond the stopping distance

}  // namespace

Advice advice_of(const Passage& passage) {
  return {passage.motion, passage.blocked ? DriveState::kBlocked : DriveState::kDriving, passage.reason};
}

double PathGuard::straight_room(const Situation& situation, double clearance, Direction direction,
                                double length) const {
  return free_path(outline_, clearance, situation.points, straight_path(direction, kPathStep_m, length)).length;
}

Passage PathGuard::straight(const Situation& situation, double clearance, Direction direction, double speed,
                            PassageState& state) const {
  Motion desired;
  desired.speed = sign_of(direction) * speed;
  return along(straight_path(direction, kPathStep_m, horizon()), situation, clearance, desired, state);
}

Passage PathGuard::course(const CourseParameters& parameters, const Situation& situation, double clearance,
                          const geometry::PlanePose& X_VR, Direction direction, const Motion& desired,
                          PassageState& state) const {
  const auto path = course_path(parameters, X_VR, direction, kPathStep_m, horizon());
  return along(path, situation, clearance, desired, state);
}

Passage PathGuard::along(const std::vector<PathPose>& path, const Situation& situation, double clearance,
                         const Motion& desired, PassageState& state) const {
  const FreePath free = free_path(outline_, clearance, situation.points, path);
  return pass(passage_, motion_.acceleration, free, clearance, std::abs(desired.speed), desired, situation.utime,
              state);
}

GuardedTurn PathGuard::turn(const Situation& situation, double clearance, double angle, double rate,
                            PassageState& state) const {
  const double kept = std::min(clearance, passage_.turn_clearance);
  const FreePath free = free_path(outline_, kept, situation.points, turning_path(outline_, angle, kPathStep_m));
  const double reach = outline_.reach();
  Motion desired;
  desired.turn_rate = std::copysign(rate, angle);
  return {pass(passage_, motion_.turn_acceleration * reach, free, kept, rate * reach, desired, situation.utime, state),
          free};
}

// m of path that matters: what it takes to stop comfortably from the greatest speed.
double PathGuard::horizon() const {
  return stopping_distance(motion_.speed, motion_.acceleration, passage_.reaction) + kBeyondStop_m;
}

}  // namespace markservo::base_navigator
