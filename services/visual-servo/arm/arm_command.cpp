#include "services/visual-servo/arm/arm_command.hpp"

#include <cmath>

#include "services/visual-servo/arm/joint_limits.hpp"

namespace markservo::visual_servo {
namespace {

constexpr double kFactorFrame_s = 1.0 / 30.0;  // in which slow_down_factor acts once
constexpr double kRampReserve = 1.05;          // ramps end a little before the next command
constexpr double kSlowestRamp = 0.2;           // rad/s
constexpr double kAtOnce_s = 0.008;       // a step of this length outruns the motor, and ends within a servo's pulse
constexpr double kNegligibleStep = 1e-4;  // rad

JointVector speed_limit_of(const robot::ArmDescription& arm, const ArmStep& step, double seconds) {
  JointVector wanted = JointVector::Constant(step.joint_speed);
  if (step.streaming) {
    wanted = (step.change.cwiseAbs() * (kRampReserve / seconds)).cwiseMax(kSlowestRamp);
  } else if (std::isinf(step.joint_speed)) {
    wanted = (step.change.cwiseAbs() / kAtOnce_s).cwiseMax(kSlowestRamp);
  }
  return wanted.cwiseMin(servo_speeds(arm));
}

}  // namespace

void ArmCommand::adopt(const JointSample& now) {
  begun_ = true;
  adoption_due_ = false;
  position_ = now.position;
  // Nothing is to move by it: slow, so that an arm that is elsewhere refuses it as leading its shafts too far.
  speed_limit_.setConstant(kSlowestRamp);
  since_ = now.utime;
  hold();
}

void ArmCommand::slow_down(const robot::ArmDescription& arm, const ArmCommandParameters& parameters, std::int64_t now,
                           double seconds) {
  if (last_step_.isZero()) return;
  waiting_ += seconds;
  last_step_ *= std::pow(parameters.slow_down_factor, seconds / kFactorFrame_s);
  if (waiting_ > parameters.slow_down_time || last_step_.cwiseAbs().maxCoeff() < kNegligibleStep) {
    hold();
    return;
  }
  position_ = inside_limits(arm, position_ + last_step_);
  since_ = now;
}

std::string ArmCommand::move(const robot::ArmDescription& arm, const ArmCommandParameters& parameters,
                             const ArmStep& step, const JointSample& now, double seconds) {
  const JointVector next = position_ + step.change;
  const JointVector lead = (next - now.position).cwiseAbs();
  int joint = 0;
  if (lead.maxCoeff(&joint) > parameters.follow_lead) {
    hold();
    return "the arm does not follow: joint " + arm.joints[static_cast<std::size_t>(joint)].name;
  }
  waiting_ = 0.0;
  if (step.streaming) {
    last_step_ = step.change;
  } else {
    hold();
  }
  if (step.change.isZero()) return "";
  position_ = next;
  since_ = now.utime;
  speed_limit_ = speed_limit_of(arm, step, seconds);
  return "";
}

std::optional<std::int64_t> ArmCommand::at_rest_since(const SettlingParameters& parameters,
                                                      const JointHistory& joints) const {
  return visual_servo::at_rest_since(parameters, joints, position_, since_);
}

void ArmCommand::relax(const SettlingParameters& parameters, const JointHistory& joints) {
  if (at_rest_since(parameters, joints)) speed_limit_.setConstant(kSlowestRamp);
}

bool ArmCommand::settled_at(const SettlingParameters& parameters, const JointHistory& joints,
                            std::int64_t utime) const {
  const auto since = at_rest_since(parameters, joints);
  return since && seconds_between(*since, utime) >= parameters.settle_time;
}

}  // namespace markservo::visual_servo
