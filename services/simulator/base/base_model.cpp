#include "services/simulator/base/base_model.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace markservo::simulator {
namespace {

// Independent streams of one seed.
constexpr std::uint64_t kScaleStream = 0x51;
constexpr std::uint64_t kLeftStream = 0x52;
constexpr std::uint64_t kRightStream = 0x53;
constexpr std::uint64_t kCounterStream = 0x54;
constexpr std::uint64_t kWanderStream = 0x55;

// m of way. A share per stretch, not noise per step: the true speed stays smooth and the step size does not matter.
constexpr double kSlipStretch = 0.10;
constexpr double kNoiseStretch = 0.02;
// rad of turning: little of what happens between two rounds of a reader.
constexpr double kWanderStretch = 0.02;

constexpr double kMostSlip = 0.5;
constexpr double kMostWander = 0.5;   // m per sqrt(rad)
constexpr double kWrapWithin = 0.25;  // m of forward way

void require(bool good, const char* what, double value, const char* allowed) {
  if (good) return;
  throw std::invalid_argument(std::string("BaseModel: ") + what + " is " + std::to_string(value) +
                              "; allowed: " + allowed);
}

double approach(double from, double to, double most) {
  return from + std::clamp(to - from, -most, most);
}

std::int64_t first_count(const robot::BaseDescription& base, std::uint64_t seed, std::uint64_t wheel) {
  const double before_wrap = kWrapWithin * RandomBits(seed_for(seed, kCounterStream, wheel)).uniform();
  return (std::int64_t{1} << base.counter_bits) - 1 - std::llround(before_wrap / base.metres_per_tick());
}

// Where a robot at `pose` is after its middle went `way` along an arc that turns by `turn`; its heading is
// not wrapped.
geometry::PlanePose along_arc(const geometry::PlanePose& pose, double way, double turn) {
  const double chord = geometry::chord(way, turn);
  const double direction = pose.heading + 0.5 * turn;
  return {pose.x + chord * std::cos(direction), pose.y + chord * std::sin(direction), pose.heading + turn};
}

}  // namespace

double BaseModel::Wheel::roll(double way, const BaseModelParameters& parameters, double noise_per_sqrt_m) {
  if (way == 0.0) return 0.0;
  if (travelled_ >= slip_until_) {
    slip_share_ = 2.0 * parameters.slip * bits_.uniform();
    slip_until_ += kSlipStretch;
  }
  if (travelled_ >= noise_until_) {
    noise_share_ = noise_per_sqrt_m / std::sqrt(kNoiseStretch) * bits_.gaussian();
    noise_until_ += kNoiseStretch;
  }
  way_ += way;
  travelled_ += std::abs(way);
  return way * (1.0 - slip_share_ + noise_share_);
}

Eigen::Vector2d BaseModel::Wander::turn(double turn, double wander_per_sqrt_rad) {
  turned_ += std::abs(turn);
  if (wander_per_sqrt_rad == 0.0 || turn == 0.0) return Eigen::Vector2d::Zero();
  if (turned_ >= until_) {
    const double sigma = wander_per_sqrt_rad / std::sqrt(kWanderStretch);
    push_.x() = sigma * bits_.gaussian();
    push_.y() = sigma * bits_.gaussian();
    until_ = turned_ + kWanderStretch;
  }
  return std::abs(turn) * push_;
}

std::int64_t BaseModel::Wheel::turned(double tick) const {
  return static_cast<std::int64_t>(std::floor(way_ / tick));
}

BaseModel::BaseModel(const robot::BaseDescription& base, const BaseModelParameters& parameters,
                     const geometry::PlanePose& start, std::uint64_t seed)
    : base_(base),
      parameters_(parameters),
      tick_(base.metres_per_tick()),
      // Both wheels' noise together turns the robot: var(heading) = 2 n^2 / track^2 after 1 m.
      noise_per_sqrt_m_(parameters.drift * base.track / std::sqrt(2.0)),
      scale_(1.0 + parameters.scale_sigma * RandomBits(seed_for(seed, kScaleStream, 0)).gaussian()),
      pose_(start),
      left_(seed_for(seed, kLeftStream, 0), first_count(base, seed, 0)),
      right_(seed_for(seed, kRightStream, 0), first_count(base, seed, 1)),
      wander_(seed_for(seed, kWanderStream, 0)) {
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
  wanted_.speed = std::clamp(speed, -base_.speed_max, base_.speed_max);
  wanted_.turn_rate = std::clamp(turn_rate, -base_.turn_rate_max, base_.turn_rate_max);
}

void BaseModel::step(double dt) {
  require(std::isfinite(dt) && dt > 0.0, "dt", dt, "above 0 s");
  const Motion old = wheels_;
  wheels_.speed = approach(old.speed, wanted_.speed, base_.acceleration_max * dt);
  wheels_.turn_rate = approach(old.turn_rate, wanted_.turn_rate, base_.turn_acceleration_max * dt);
  const double told_way = 0.5 * (old.speed + wheels_.speed) * dt;
  const double told_turn = 0.5 * (old.turn_rate + wheels_.turn_rate) * dt;

  const double half_track = 0.5 * base_.track;
  const double left = scale_ * left_.roll(told_way - half_track * told_turn, parameters_, noise_per_sqrt_m_);
  const double right = scale_ * right_.roll(told_way + half_track * told_turn, parameters_, noise_per_sqrt_m_);
  const double way = 0.5 * (left + right);
  const double turn = (right - left) / base_.track;
  pose_ = along_arc(pose_, way, turn);
  const Eigen::Vector2d push = wander_.turn(told_turn, parameters_.pivot_wander);
  pose_.x += push.x();
  pose_.y += push.y();
  true_motion_ = {way / dt, turn / dt};
}

WheelTicks BaseModel::ticks() const {
  return {wrapped(left_.counter(tick_)), wrapped(right_.counter(tick_))};
}

std::int32_t BaseModel::wrapped(std::int64_t count) const {
  const std::int64_t range = std::int64_t{1} << base_.counter_bits;
  const std::int64_t positive = ((count % range) + range) % range;
  return static_cast<std::int32_t>(static_cast<std::uint32_t>(positive));
}

}  // namespace markservo::simulator
