#pragma once

// What an RC servo makes of its commands: a ramp at limited speed, a deadband, a motor that follows with limited
// acceleration, backlash. One joint, no clock: the caller says how much time passes. Angles in rad.

namespace markservo::simulator {

enum class DeadbandKind {
  kStopsAtEdge,  // moves only as far as the deadband's edge
  kRunsHome,     // once the command has left the deadband, runs until it is exactly there
};

struct ServoParameters {
  double speed = 5.24;          // rad/s, the servo's own limit, above 0
  double acceleration = 100.0;  // rad/s2 of the motor, above 0: 1 N m on the 0.01 kg m2 of a small arm
  double deadband = 0.0;        // rad, half-width, 0 or more
  DeadbandKind deadband_kind = DeadbandKind::kStopsAtEdge;
  double backlash = 0.0;  // rad, full width of the play between motor and joint
};

class ServoModel {
 public:
  // At rest at `angle`.
  explicit ServoModel(double angle) : target_(angle), ramp_(angle), motor_(angle), shaft_(angle) {}

  // A new target, approached at no more than `speed_limit` (rad/s) and the servo's own speed.
  void command(double target, double speed_limit);

  // The ramp stops where it is.
  void freeze() { target_ = ramp_; }

  // Lets `dt` (s) pass.
  void step(const ServoParameters& parameters, double dt);

  double target() const { return target_; }
  double ramp() const { return ramp_; }                // rad, what is commanded to the servo now
  double motor() const { return motor_; }              // rad, behind the deadband
  double shaft() const { return shaft_; }              // rad, behind the backlash
  double ramp_speed() const { return ramp_speed_; }    // rad/s, over the last step
  double shaft_speed() const { return shaft_speed_; }  // rad/s, over the last step
  bool moving() const { return ramp_ != target_; }

 private:
  void drive_motor(const ServoParameters& parameters, double goal, double dt);

  double target_;
  double speed_limit_ = 0.0;  // rad/s
  double ramp_;
  double motor_;
  double motor_speed_ = 0.0;  // rad/s
  double shaft_;
  double ramp_speed_ = 0.0;
  double shaft_speed_ = 0.0;
  bool running_home_ = false;
};

}  // namespace markservo::simulator
