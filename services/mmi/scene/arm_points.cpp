#include "services/mmi/scene/arm_points.hpp"

#include <stdexcept>
#include <string>

#include "common/robot/arm_kinematics.hpp"
#include "services/mmi/scene/camera_pose.hpp"
#include "services/mmi/scene/vector_json.hpp"

namespace markservo::mmi {
namespace {

nlohmann::ordered_json points_json(const std::optional<ArmPoints>& points) {
  if (!points) return nullptr;
  auto list = nlohmann::ordered_json::array();
  for (const Eigen::Vector3d& point : *points) list.push_back(vector_json(point));
  return list;
}

}  // namespace

ArmPoints arm_points(const robot::RobotDescription& robot, const robot::JointVector& q) {
  if (!robot.arm) throw std::invalid_argument("arm_points: the robot has no arm; allowed: robots with one");
  const Eigen::Isometry3d X_CA = robot::arm_base_pose(*robot.arm);
  robot::ArmDescription without_forearm = *robot.arm;
  without_forearm.forearm = 0.0;  // then the grip point is the elbow
  const Eigen::Isometry3d X_RC = camera_pose(robot.cameras);
  return {X_RC * X_CA.translation(), X_RC * (X_CA * Eigen::Vector3d(0.0, 0.0, robot.arm->column)),
          X_RC * robot::grip_point(without_forearm, q), X_RC * robot::grip_point(*robot.arm, q)};
}

ArmView::ArmView(const robot::RobotDescription& robot) : robot_(robot) {}

void ArmView::observe(const Report& report) {
  const auto* joints = std::get_if<JointReport>(&report);
  if (joints == nullptr || !robot_.arm) return;
  const ArmPoints points = arm_points(robot_, joints->q);
  if (joints->commanded) {
    commanded_ = points;
  } else {
    measured_ = points;
    utime_ = joints->utime;
  }
  ++version_;
}

nlohmann::ordered_json ArmView::json() const {
  if (!measured_) return nullptr;
  return {
      {"utime", std::to_string(utime_)}, {"measured", points_json(measured_)}, {"commanded", points_json(commanded_)}};
}

}  // namespace markservo::mmi
