#include "services/task-manager/plans/drive_field.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>

namespace markservo::task_manager {

std::string why_off_the_field(const robot::RobotDescription& robot, const std::string& field,
                              const geometry::PlanePose& X_WR) {
  if (!robot.floor_tags) return "";
  const robot::TagField& tags = robot.floor_tags->field(field);
  Eigen::AlignedBox2d around;
  for (const robot::FloorTag& tag : tags.tags) around.extend(tag.p_W);
  const Eigen::Vector2d beside = Eigen::Vector2d::Constant(robot.rfid ? robot.rfid->reading_radius : 0.0);
  const Eigen::AlignedBox2d allowed(around.min() - beside, around.max() + beside);
  if (allowed.contains(Eigen::Vector2d(X_WR.x, X_WR.y))) return "";
  return fmt::format(
      "the drive to x {:.2f} m, y {:.2f} m leaves the floor's tags; allowed on field {:.40}: x {:.2f} to {:.2f} m, "
      "y {:.2f} to {:.2f} m",
      X_WR.x, X_WR.y, tags.name, allowed.min().x(), allowed.max().x(), allowed.min().y(), allowed.max().y());
}

}  // namespace markservo::task_manager
