#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>

#include "services/mmi/scene/reports.hpp"

namespace markservo::mmi {

// `places` of an update: the marks of the newest TARGET_POSE in R, and the goal of the grip point.
class Places {
 public:
  explicit Places(const robot::RobotDescription& robot);

  // Takes target reports and servo goals, nothing else.
  void observe(const Report& report);

  // Grows whenever json() has become another; 0: nothing heard.
  std::uint64_t version() const { return version_; }
  // Null until the first TARGET_POSE. p_R, covariance_R and normal_R are null of a mark that is not located, normal_R
  // also where no plane carries it; grip_goal_R while there is no goal by sight or its target is not located.
  nlohmann::ordered_json json() const;

  // m in R, where the newest goal wants the grip point, by the newest place of its target.
  std::optional<Eigen::Vector3d> grip_goal() const;

 private:
  nlohmann::ordered_json mark_json(const MarkReport& mark) const;

  Eigen::Isometry3d X_RC_;
  std::uint64_t version_ = 0;
  std::optional<TargetReport> targets_;
  std::optional<ServoGoalReport> goal_;
};

}  // namespace markservo::mmi
