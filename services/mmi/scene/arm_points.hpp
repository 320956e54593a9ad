#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>

#include "services/mmi/scene/reports.hpp"

namespace markservo::mmi {

// The ends of the arm's links: foot of the column, shoulder, elbow, grip point.
using ArmPoints = std::array<Eigen::Vector3d, 4>;

// They are at `q`, m in R. Throws std::invalid_argument if the robot has no arm.
ArmPoints arm_points(const robot::RobotDescription& robot, const robot::JointVector& q);

// `arm` of an update: where the arm is and where it was told to go, newest each.
class ArmView {
 public:
  explicit ArmView(const robot::RobotDescription& robot);

  // Takes joint reports of a robot with an arm, nothing else.
  void observe(const Report& report);

  // Grows whenever json() has become another; 0: nothing heard.
  std::uint64_t version() const { return version_; }
  // {utime, measured, commanded}; null until the arm has said where it is.
  nlohmann::ordered_json json() const;

 private:
  robot::RobotDescription robot_;
  std::uint64_t version_ = 0;
  std::int64_t utime_ = 0;  // us, of the measurement
  std::optional<ArmPoints> measured_;
  std::optional<ArmPoints> commanded_;
};

}  // namespace markservo::mmi
