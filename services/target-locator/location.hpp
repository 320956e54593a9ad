#pragma once

// What the locator answers of one mark.

#include <Eigen/Core>
#include <vector>

#include "common/states/mark_cue.hpp"
#include "common/states/mark_status.hpp"

namespace markservo::target_locator {

using Status = MarkStatus;
using Cue = MarkCue;

struct Match {
  double u_left = 0.0;    // px
  double v_left = 0.0;    // px
  double u_right = 0.0;   // px
  double v_right = 0.0;   // px
  double residual = 0.0;  // px, distance from the plane's disparity (plane) or the match's own sigma (free)
};

struct Location {
  Status status = Status::kUnseen;
  Cue cue = Cue::kNone;                                  // what carries the position; none unless located
  Eigen::Vector3d p_C = Eigen::Vector3d::Zero();         // m, the mark's centre; valid when located
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();  // m^2, of p_C
  Eigen::Vector3d normal_C = Eigen::Vector3d::Zero();    // towards the cameras; zero when it is not known
  std::vector<Match> matches;                            // those that agree; given for a clipped mark as well
};

}  // namespace markservo::target_locator
