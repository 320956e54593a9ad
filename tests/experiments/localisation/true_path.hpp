#pragma once

// Where the base truly was, at any time of a run.

#include <Eigen/Core>
#include <vector>

namespace markservo::experiments {

struct PathPoint {
  double time = 0.0;                               // s
  Eigen::Vector2d p_WR = Eigen::Vector2d::Zero();  // m
  double heading = 0.0;                            // rad, of the robot's x in W; never wrapped along a path
  double speed = 0.0;                              // m/s, forward
  double turn_rate = 0.0;                          // rad/s, counter-clockwise
  double wheel_travel = 0.0;                       // m, of a wheel on average, both directions added up; 0: not told
  double turned = 0.0;                             // rad, as the wheels tell it, both directions added up

  // m in W, of a point fixed at `p_R` on the robot
  Eigen::Vector2d at(const Eigen::Vector2d& p_R) const;
};

// A path sampled densely enough that straight lines between the samples will do (50 Hz: 0.01 mm on a circle of 0.8 m).
class TruePath {
 public:
  // Throws std::invalid_argument unless there are two points or more and their times rise.
  explicit TruePath(std::vector<PathPoint> points);

  // Between the samples, interpolated; before the first and after the last one moved on at constant speed and turn
  // rate zero.
  PathPoint at(double time) const;
  const std::vector<PathPoint>& points() const { return points_; }

 private:
  std::vector<PathPoint> points_;
};

}  // namespace markservo::experiments
