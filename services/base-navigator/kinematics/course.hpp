#pragma once

// The steering law: how to curve so as to reach a pose with its heading.
//
// J. J. Park and B. Kuipers, "A smooth control law for graceful motion of differential wheeled mobile robots in 2D
// environment", ICRA 2011, eq. (14): curvature from the distance r, and the directions of the goal and of the robot
// against the line of sight. Its curvature grows without bound as r falls to 0, so the last part of the path aims at a
// point that keeps `lookahead` ahead on the goal's axis: the robot follows that axis until it has reached the goal.

#include <vector>

#include "common/geometry/plane_pose.hpp"
#include "services/base-navigator/kinematics/path.hpp"

namespace markservo::base_navigator {

struct CourseParameters {
  double k1 = 1.5;          // how much earlier than the robot's position its heading is given up for the path's shape
  double k2 = 3.0;          // how much faster the heading follows than the position: the paper's own
  double lookahead = 0.25;  // m; shorter follows pose noise of 1 cm with jerks, longer leaves more lateral error
  double curvature_max = 4.0;  // 1/m
};

struct Course {
  double curvature = 0.0;      // rad per m of path, counter-clockwise; forward and backward alike
  double remaining = 0.0;      // m along the goal's axis; below 0 once it is passed
  double heading_error = 0.0;  // rad, by how much the robot would have to turn first to be on the law's path
};

// For the robot's pose in the goal's frame. A backward course arrives with the goal's heading too.
Course steer(const CourseParameters& parameters, const geometry::PlanePose& X_GR, Direction direction);

// The poses that the law leads through, every `step` m, up to the goal or for `length` m; never fewer than two.
std::vector<PathPose> course_path(const CourseParameters& parameters, const geometry::PlanePose& X_GR,
                                  Direction direction, double step, double length);

}  // namespace markservo::base_navigator
