#include "services/simulator/base/base_model.hpp"

#include <cmath>
#include <stdexcept>
#include <string>

#include "services/simulator/random.hpp"

namespace markservo::simulator {
namespace {

constexpr double kMostSlip = 0.5;
constexpr double kMostWander = 0.5;   // m per sqrt(rad)
constexpr double kWrapWithin = 0.25;  // m of forward way

void require(bool good, const char* what, double value, const char* allowed) {
  if (good) return;
  throw std::invalid_argument(std::string("BaseModel: ") + what + " is " + std::to_string(value) +
                              "; allowed: " + allowed);
}

WheelEncoder encoder(const robot::BaseDescription& base, std::uint64_t seed, std::uint64_t wheel) {
  const double before_wrap = kWrapWithin * RandomBits(seed_for(seed, streams::kFirstCount, wheel)).uniform();
  const std::int64_t first_count =
      (std::int64_t{1} << base.counter_bits) - 1 - std::llround(before_wrap / base.metres_per_tick());
  return {base.metres_per_tick(), base.counter_bits, first_count};
}

// Both wheels' noise together turns the robot: var(heading) = 2 n^2 / track^2 after 1 m.
WheelGripParameters grip_parameters(const robot::BaseDescription& base, const BaseModelParameters& parameters) {
  return {parameters.slip, parameters.drift * base.track / std::sqrt(2.0)};
}

// Where a robot at `pose` is after its middle went `way` along an arc that turns by `turn`; its heading is
// not wrapped.
geometry::PlanePose along_arc(const geometry::PlanePose& pose, double way, double turn) {
  const double chord = geometry::chord(way, turn);
  const double direction = pose.heading + 0.5 * turn;
  return {pose.x + chord * std::cos(direction), pose.y + chord * std::sin(direction), pose.heading + turn};
}

}  // namespace

double BaseModel::Wheel::roll(double way) {
  encoder.turn(way);
  return grip.roll(way);
}

BaseModel::BaseModel(const robot::BaseDescription& base, const BaseModelParameters& parameters,
                     const geometry::PlanePose& start, std::uint64_t seed)
    : track_(base.track),
      scale_(1.0 + parameters.scale_sigma * RandomBits(seed_for(seed, streams::kWheelScale, 0)).gaussian()),
      drive_(base),
      left_{encoder(base, seed, 0), {grip_parameters(base, parameters), seed_for(seed, streams::kLeftGrip, 0)}},
      right_{encoder(base, seed, 1), {grip_parameters(base, parameters), seed_for(seed, streams::kRightGrip, 0)}},
      wander_(parameters.pivot_wander, seed_for(seed, streams::kPivotWander, 0)),
      pose_(start) {
  require(parameters.scale_sigma >= 0.0 && parameters.scale_sigma <= 0.2, "scale_sigma", parameters.scale_sigma,
          "0 to 0.2");
  require(parameters.drift >= 0.0 && parameters.drift <= 1.0, "drift", parameters.drift, "0 to 1 rad per sqrt(m)");
  require(parameters.slip >= 0.0 && parameters.slip <= kMostSlip, "slip", parameters.slip, "0 to 0.5");
  require(parameters.pivot_wander >= 0.0 && parameters.pivot_wander <= kMostWander, "pivot_wander",
          parameters.pivot_wander, "0 to 0.5 m per sqrt(rad)");
  for (const double value : {start.x, start.y, start.heading}) {
    require(std::isfinite(value), "start pose", value, "finite numbers");
  }
}

void BaseModel::command(double speed, double turn_rate) {
  require(std::isfinite(speed), "speed", speed, "a finite number");
  require(std::isfinite(turn_rate), "turn_rate", turn_rate, "a finite number");
  drive_.command({speed, turn_rate});
}

void BaseModel::step(double dt) {
  require(std::isfinite(dt) && dt > 0.0, "dt", dt, "above 0 s");
  const BaseDrive::Travel told = drive_.step(dt);
  const double half_track = 0.5 * track_;
  const double left = scale_ * left_.roll(told.way - half_track * told.turn);
  const double right = scale_ * right_.roll(told.way + half_track * told.turn);
  const double way = 0.5 * (left + right);
  const double turn = (right - left) / track_;
  pose_ = along_arc(pose_, way, turn);
  const Eigen::Vector2d push = wander_.turn(told.turn);
  pose_.x += push.x();
  pose_.y += push.y();
  true_motion_ = {way / dt, turn / dt};
}

WheelTicks BaseModel::ticks() const {
  return {left_.encoder.counter(), right_.encoder.counter()};
}

}  // namespace markservo::simulator
