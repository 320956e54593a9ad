#pragma once

// A differential drive on the floor: what its encoders tell and where it really goes. No clock: the caller says how
// much time passes.

#include <cstdint>

#include "common/geometry/plane_pose.hpp"
#include "common/robot/robot_description.hpp"
#include "services/simulator/base/base_drive.hpp"
#include "services/simulator/base/pivot_wander.hpp"
#include "services/simulator/base/wheel_encoder.hpp"
#include "services/simulator/base/wheel_grip.hpp"

namespace markservo::simulator {

// How the true motion differs from what the encoders tell.
struct BaseModelParameters {
  double scale_sigma = 0.02;  // standard deviation of one factor for both wheels, drawn once: tyres, load
  double drift = 0.0349;      // rad per sqrt(m): random walk of the heading, 2 degrees after a metre
  double slip = 0.0;          // mean share of a wheel's turning that moves nothing, [0, 0.5]
  double pivot_wander = 0.0;  // m per sqrt(rad), each axis: random walk of the place while the base turns
};

// Raw counters, from 0 to 2^counter_bits - 1 (all 32 bits of an int32 at counter_bits 32).
struct WheelTicks {
  std::int32_t left = 0;
  std::int32_t right = 0;
};

class BaseModel {
 public:
  // At rest at X_WR = `start`; the counters start less than 0.25 m of forward motion below their wrap-around. Throws
  // std::invalid_argument for parameters below 0, a slip above 0.5 or a start that is not finite.
  BaseModel(const robot::BaseDescription& base, const BaseModelParameters& parameters, const geometry::PlanePose& start,
            std::uint64_t seed);

  // Wanted speed (m/s, forward) and turn rate (rad/s, counter-clockwise) of the wheels as the encoders measure them;
  // approached with the description's accelerations, cut to its limits. Throws std::invalid_argument unless finite.
  void command(double speed, double turn_rate);

  // Brakes to a stand with the same accelerations.
  void freeze() { command(0.0, 0.0); }

  // Lets `dt` (s, above 0) pass.
  void step(double dt);

  const geometry::PlanePose& pose() const { return pose_; }    // the true X_WR
  double speed() const { return true_motion_.speed; }          // m/s, the true one over the last step
  double turn_rate() const { return true_motion_.turn_rate; }  // rad/s, the true one over the last step

  WheelTicks ticks() const;
  double left_distance() const { return left_.encoder.distance(); }    // m since the start, from the ticks
  double right_distance() const { return right_.encoder.distance(); }  // m

  // What the noise comes from, both directions added up since the start.
  double wheel_travel() const {
    return 0.5 * (left_.grip.travelled() + right_.grip.travelled());
  }                                                   // m, of a wheel on average
  double turned() const { return wander_.turned(); }  // rad, as the wheels tell it

 private:
  struct Wheel {
    WheelEncoder encoder;
    WheelGrip grip;

    // The true distance (m) that the wheel goes while its encoder turns by `way` (m).
    double roll(double way);
  };

  double track_;  // m
  double scale_;  // true way over told way
  BaseDrive drive_;
  Wheel left_;
  Wheel right_;
  PivotWander wander_;
  geometry::PlanePose pose_;
  BaseMotion true_motion_;  // over the last step
};

}  // namespace markservo::simulator
