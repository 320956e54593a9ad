#pragma once

// Whether a standing robot can take a target, from geometry alone (config/robot.yaml): reach, room for the fingers, and
// both marks in both images at the grip.

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <string>

#include "common/robot/robot_description.hpp"

namespace markservo::robot {

enum class GripVerdict {
  kFeasible,
  kUnreachable,  // wins over kOutOfView
  kOutOfView,
};

struct GripJudgement {
  GripVerdict verdict = GripVerdict::kUnreachable;
  std::string reason;  // for people; empty when feasible
};

// Judges the target whose mark's centre is at `p_CT` (m). `target` must have a grip description, `robot` an arm and one
// mark of role manipulator; throws std::invalid_argument otherwise.
GripJudgement judge_grip(const RobotDescription& robot, const MarkDescription& target, const Eigen::Vector3d& p_CT);

// The least distance from an image border, px, of a square mark of edge `size` (m) at `X_CM` (edges along its x and z),
// over both images; negative outside, minus infinity behind the lenses.
double view_margin_px(const CameraDescription& cameras, const Eigen::Isometry3d& X_CM, double size);

// "feasible", "unreachable", "out_of_view".
const char* name_of(GripVerdict verdict);

}  // namespace markservo::robot
