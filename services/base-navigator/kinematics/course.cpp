#include "services/base-navigator/kinematics/course.hpp"

#include <algorithm>
#include <cmath>

namespace markservo::base_navigator {

using geometry::PlanePose;
using geometry::wrapped;

Course steer(const CourseParameters& parameters, const PlanePose& X_GR, Direction direction) {
  // Driving backward is driving forward with robot and goal turned round.
  const double x = sign_of(direction) * X_GR.x;
  const double y = sign_of(direction) * X_GR.y;
  Course course;
  course.remaining = -x;
  const double aim_x = std::max(0.0, parameters.lookahead + x);
  const double r = std::max(std::hypot(aim_x - x, y), parameters.lookahead);
  const double line_of_sight = std::atan2(-y, aim_x - x);
  const double theta = wrapped(-line_of_sight);
  const double delta = wrapped(X_GR.heading - line_of_sight);
  const double wanted = std::atan(-parameters.k1 * theta);
  course.heading_error = wrapped(wanted - delta);
  const double bend = parameters.k1 / (1.0 + std::pow(parameters.k1 * theta, 2));
  const double curvature = -(parameters.k2 * wrapped(delta - wanted) + (1.0 + bend) * std::sin(delta)) / r;
  course.curvature = std::clamp(curvature, -parameters.curvature_max, parameters.curvature_max);
  return course;
}

std::vector<PathPose> course_path(const CourseParameters& parameters, const PlanePose& X_GR, Direction direction,
                                  double step, double length) {
  const PlanePose X_RG = X_GR.inverse();
  std::vector<PathPose> path = {{PlanePose(), 0.0}};
  PlanePose X_GS = X_GR;
  for (double gone = 0.0; gone < length;) {
    const Course course = steer(parameters, X_GS, direction);
    if (course.remaining <= 0.0 && path.size() > 1) break;
    const double ds = std::clamp(course.remaining, 0.2 * step, step);
    X_GS = X_GS * PlanePose{sign_of(direction) * ds, 0.0, course.curvature * ds};
    gone += ds;
    path.push_back({X_RG * X_GS, gone});
  }
  return path;
}

}  // namespace markservo::base_navigator
