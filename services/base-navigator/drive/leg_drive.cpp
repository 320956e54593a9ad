#include "services/base-navigator/drive/leg_drive.hpp"

#include <algorithm>
#include <cmath>

#include "services/base-navigator/kinematics/speed_profile.hpp"

namespace markservo::base_navigator {
namespace {

constexpr double kStraight = 1e-3;  // 1/m; a smaller curvature limits no speed

double allowed_speed(const MotionParameters& motion, const Assignment& goal, const Course& course) {
  double speed = std::min(goal.speed, motion.speed);
  speed = std::min(speed, stopping_speed(course.remaining, motion.acceleration, motion.goal_reaction));
  speed = std::min(speed, motion.turn_rate / std::max(std::abs(course.curvature), kStraight));
  return std::max(speed, std::min(motion.creep, goal.speed));
}

}  // namespace

Course course_of(const LegDriveParameters& parameters, const Leg& leg, const Situation& situation) {
  return steer(parameters.course, leg.X_WV.inverse() * situation.X_WR, leg.direction);
}

LegStep drive_leg(const LegDriveParameters& parameters, const PathGuard& guard, const Situation& situation,
                  const Assignment& goal, const Leg& leg, PassageState& passage) {
  const MotionParameters& motion = guard.motion();
  const Course course = course_of(parameters, leg, situation);
  if (course.remaining <= (leg.to_goal ? parameters.end : parameters.loose_end)) return {LegProgress::kEnded, {}};
  if (std::abs(course.heading_error) > parameters.off_course) return {LegProgress::kOffCourse, {}};
  if (situation.measured.speed * sign_of(leg.direction) < -motion.rolling) return {LegProgress::kUnderWay, {}};
  Motion desired;
  desired.speed = sign_of(leg.direction) * allowed_speed(motion, goal, course);
  desired.curvature = course.curvature;
  const geometry::PlanePose X_VR = leg.X_WV.inverse() * situation.X_WR;
  LegStep step;
  step.passage = guard.course(parameters.course, situation, goal.clearance, X_VR, leg.direction, desired, passage);
  if (step.passage.blocked) step.progress = LegProgress::kBlocked;
  return step;
}

}  // namespace markservo::base_navigator
