#include "tests/experiments/wander/pivot_drive.hpp"

#include <algorithm>
#include <cmath>

#include "services/simulator/random.hpp"
#include "tests/experiments/localisation/field_box.hpp"
#include "tests/experiments/localisation/steering_law.hpp"

namespace markservo::experiments {
namespace {

using geometry::PlanePose;
using simulator::RandomBits;

constexpr std::uint64_t kLegStream = 0xC4;

constexpr double kPivotGain = 4.0;  // 1/s
constexpr double kThere = 0.003;    // m
constexpr double kTurned = 0.005;   // rad

// rad, up or down W's x (axis 0) or y (axis 1).
double heading_along(int axis, bool up) {
  if (axis == 0) return up ? 0.0 : M_PI;
  return up ? 0.5 * M_PI : -0.5 * M_PI;
}

// Follows the legs, one after the other.
class LegControl {
 public:
  LegControl(const PivotDrive& course, const FieldBox& box, std::uint64_t seed)
      : course_(course), box_(box), bits_(simulator::seed_for(seed, kLegStream, 0)) {
    start_ = {near_side(0), near_side(1), 0.0};
    begin_leg({start_.x, start_.y});
  }

  const PlanePose& start() const { return start_; }

  // Speed (m/s) and turn rate (rad/s) for the base at `pose`, `time` s after the begin; called every kControlPeriod.
  Eigen::Vector2d command(const PlanePose& pose, double time) {
    if (time >= course_.leg_time * (legs_ + 1) && legs_ + 1 < course_.pivots) {
      ++legs_;
      pivoting_ = false;
      begin_leg({pose.x, pose.y});
    }
    return pivoting_ ? pivot(pose) : follow(pose);
  }

 private:
  double near_side(int axis) { return box_.least[axis] + course_.margin + course_.turning_band * bits_.uniform(); }
  double far_side(int axis) { return box_.greatest[axis] - course_.margin - course_.turning_band * bits_.uniform(); }

  // To the other side, along x and y in turn.
  void begin_leg(const Eigen::Vector2d& p_W) {
    const int axis = legs_ % 2;
    const bool up = p_W[axis] < box_.middle()[axis];
    begin_ = p_W;
    length_ = std::abs((up ? far_side(axis) : near_side(axis)) - p_W[axis]);
    heading_ = heading_along(axis, up);
    const int next = 1 - axis;
    next_heading_ = heading_along(next, p_W[next] < box_.middle()[next]);
  }

  Eigen::Vector2d follow(const PlanePose& pose) {
    const Eigen::Vector2d along(std::cos(heading_), std::sin(heading_));
    const Eigen::Vector2d from_begin = Eigen::Vector2d(pose.x, pose.y) - begin_;
    const double left = length_ - along.dot(from_begin);
    if (left < kThere) {
      pivoting_ = true;
      speed_ = 0.0;
      return Eigen::Vector2d::Zero();
    }
    const double wanted = std::min(course_.speed, std::sqrt(kAcceleration * left));
    speed_ = std::min(wanted, speed_ + kAcceleration * kControlPeriod);
    const double aside = along.x() * from_begin.y() - along.y() * from_begin.x();
    return {speed_, turn_rate_along(speed_, 0.0, aside, geometry::wrapped(pose.heading - heading_))};
  }

  Eigen::Vector2d pivot(const PlanePose& pose) const {
    const double missing = geometry::wrapped(next_heading_ - pose.heading);
    if (std::abs(missing) < kTurned) return Eigen::Vector2d::Zero();
    return {0.0, std::clamp(kPivotGain * missing, -course_.pivot_rate, course_.pivot_rate)};
  }

  const PivotDrive& course_;
  FieldBox box_;
  RandomBits bits_;
  PlanePose start_;
  int legs_ = 0;
  bool pivoting_ = false;
  double speed_ = 0.0;  // m/s, wanted now
  Eigen::Vector2d begin_ = Eigen::Vector2d::Zero();
  double length_ = 0.0;        // m
  double heading_ = 0.0;       // rad
  double next_heading_ = 0.0;  // rad
};

}  // namespace

Drive drive_with_pivots(const robot::RobotDescription& robot, const simulator::BaseRigParameters& parameters,
                        const PivotDrive& course, std::uint64_t seed) {
  LegControl control(course, field_box(robot.floor_tags->field(parameters.tag_field)), seed);
  const Steering steer = [&](const simulator::BaseTruth& truth, double time) {
    return control.command(truth.pose, time);
  };
  return record_drive(robot, parameters, control.start(), course.leg_time * course.pivots, steer, seed);
}

}  // namespace markservo::experiments
