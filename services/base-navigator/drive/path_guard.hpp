#pragma once

// Lets the robot move only as far and as fast as the path of its motion is free of what the sonars have seen.

#include <vector>

#include "services/base-navigator/drive/situation.hpp"
#include "services/base-navigator/kinematics/course.hpp"
#include "services/base-navigator/kinematics/motion.hpp"
#include "services/base-navigator/kinematics/outline.hpp"
#include "services/base-navigator/obstacles/free_path.hpp"
#include "services/base-navigator/obstacles/passage.hpp"

namespace markservo::base_navigator {

// A turn on the spot, and what its path is like.
struct GuardedTurn {
  Passage passage;
  FreePath free;
};

// The advice of a stage that moves by `passage`: driving or blocked.
Advice advice_of(const Passage& passage);

// Clearances in m, 0 or more; speeds above 0. `state` is the memory of the motion that is under way.
class PathGuard {
 public:
  PathGuard(const Outline& outline, const MotionParameters& motion, const PassageParameters& passage)
      : outline_(outline), motion_(motion), passage_(passage) {}

  // m of straight path that is free, `length` at most.
  double straight_room(const Situation& situation, double clearance, Direction direction, double length) const;

  // What is left of a motion straight on at `speed` (m/s).
  Passage straight(const Situation& situation, double clearance, Direction direction, double speed,
                   PassageState& state) const;

  // What is left of `desired`, with the steering law's curvature, on the course to a pose V.
  Passage course(const CourseParameters& parameters, const Situation& situation, double clearance,
                 const geometry::PlanePose& X_VR, Direction direction, const Motion& desired,
                 PassageState& state) const;

  // What is left of a turn on the spot by `angle` (rad, counter-clockwise) at `rate` (rad/s), with the passage's
  // turn_clearance at most.
  GuardedTurn turn(const Situation& situation, double clearance, double angle, double rate, PassageState& state) const;

  const MotionParameters& motion() const { return motion_; }
  const PassageParameters& passage() const { return passage_; }

 private:
  Passage along(const std::vector<PathPose>& path, const Situation& situation, double clearance, const Motion& desired,
                PassageState& state) const;
  double horizon() const;

  Outline outline_;
  MotionParameters motion_;
  PassageParameters passage_;
};

}  // namespace markservo::base_navigator
