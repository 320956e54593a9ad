#pragma once

// A differential drive on the floor: what its encoders tell and where it really goes. No clock: the caller says how
// much time passes.

#include <Eigen/Core>
#include <cstdint>

#include "common/geometry/plane_pose.hpp"
#include "common/robot/robot_description.hpp"
#include "services/simulator/random.hpp"

namespace markservo::simulator {

// How the true way differs from what the encoders tell.
struct BaseModelParameters {
  double scale_sigma = 0.02;  // standard deviation of one factor for both wheels, drawn once: tyres, load
  double drift = 0.0349;      // rad per sqrt(m): random walk of the heading, 2 degrees after a metre
  double slip = 0.0;          // mean share of a wheel's turning that makes no way, [0, 0.5]
  double pivot_wander = 0.0;  // m per sqrt(rad), each axis: random walk of the place while the base turns
};

// Raw counters, from 0 to 2^counter_bits - 1 (all 32 bits of an int32 at counter_bits 32).
struct WheelTicks {
  std::int32_t left = 0;
  std::int32_t right = 0;
};

class BaseModel {
 public:
  // At rest at X_WR = `start`; the counters start less than 0.25 m of forward way below their wrap-around. Throws
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
  double left_distance() const { return left_.distance(tick_); }    // m since the start, from the ticks
  double right_distance() const { return right_.distance(tick_); }  // m

  // What the noise comes from, both directions added up since the start.
  double wheel_travel() const { return 0.5 * (left_.travelled() + right_.travelled()); }  // m, of a wheel on average
  double turned() const { return wander_.turned(); }                                      // rad, as the wheels tell it

 private:
  // One wheel; its floor differs from stretch to stretch.
  class Wheel {
   public:
    Wheel(std::uint64_t seed, std::int64_t first_count) : bits_(seed), first_count_(first_count) {}

    // The true way (m) while the encoder turns by `way` (m).
    double roll(double way, const BaseModelParameters& parameters, double noise_per_sqrt_m);
    std::int64_t turned(double tick) const;  // whole ticks since the start
    std::int64_t counter(double tick) const { return first_count_ + turned(tick); }
    double distance(double tick) const { return static_cast<double>(turned(tick)) * tick; }
    double travelled() const { return travelled_; }  // m, both directions added up

   private:
    RandomBits bits_;
    std::int64_t first_count_;
    double way_ = 0.0;          // m, as the encoder turned
    double travelled_ = 0.0;    // m, both directions added up
    double slip_until_ = 0.0;   // m travelled
    double noise_until_ = 0.0;  // m travelled
    double slip_share_ = 0.0;   // of this stretch
    double noise_share_ = 0.0;  // of this stretch
  };

  // Where castors and tyres push the base while it turns.
  class Wander {
   public:
    explicit Wander(std::uint64_t seed) : bits_(seed) {}

    // m in W, while the base turns by `turn` (rad).
    Eigen::Vector2d turn(double turn, double wander_per_sqrt_rad);
    double turned() const { return turned_; }  // rad, both directions added up

   private:
    RandomBits bits_;
    double turned_ = 0.0;
    double until_ = 0.0;                              // rad turned
    Eigen::Vector2d push_ = Eigen::Vector2d::Zero();  // m per rad, of this stretch
  };

  struct Motion {
    double speed = 0.0;      // m/s
    double turn_rate = 0.0;  // rad/s
  };

  std::int32_t wrapped(std::int64_t count) const;

  robot::BaseDescription base_;
  BaseModelParameters parameters_;
  double tick_;              // m
  double noise_per_sqrt_m_;  // m of each wheel
  double scale_;             // true way over told way
  geometry::PlanePose pose_;
  Wheel left_;
  Wheel right_;
  Wander wander_;
  Motion wanted_;       // of the wheels
  Motion wheels_;       // as the encoders measure it
  Motion true_motion_;  // over the last step
};

}  // namespace markservo::simulator
