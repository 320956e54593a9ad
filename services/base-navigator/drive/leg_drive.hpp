#pragma once

// Driving a leg: along the steering law's course to its end, as fast as that, the goal and the obstacles allow.

#include "services/base-navigator/drive/leg_plan.hpp"
#include "services/base-navigator/drive/path_guard.hpp"
#include "services/base-navigator/drive/situation.hpp"
#include "services/base-navigator/kinematics/course.hpp"

namespace markservo::base_navigator {

struct LegDriveParameters {
  CourseParameters course;
  double off_course = 1.2;  // rad off the course while driving: the pose has jumped, plan anew
  double end = 0.004;       // m before a leg's end: what is left is less than the pose knows
  double loose_end = 0.03;  // m, likewise where another leg follows
};

enum class LegProgress {
  kUnderWay,
  kBlocked,
  kEnded,
  kOffCourse,
};

struct LegStep {
  LegProgress progress = LegProgress::kUnderWay;
  Passage passage;  // a stand where the leg has ended or the robot is off its course
};

Course course_of(const LegDriveParameters& parameters, const Leg& leg, const Situation& situation);

// Drives one step of the leg, at the goal's speed at most, and never slower than a creep unless something stands in the
// way.
LegStep drive_leg(const LegDriveParameters& parameters, const PathGuard& guard, const Situation& situation,
                  const Assignment& goal, const Leg& leg, PassageState& passage);

}  // namespace markservo::base_navigator
