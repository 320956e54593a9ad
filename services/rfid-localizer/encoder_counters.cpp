#include "services/rfid-localizer/encoder_counters.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "common/time/seconds_between.hpp"

namespace markservo::rfid_localizer {
namespace {

// Faster than the base can go by this factor, a wheel's way is a fault of the counters.
constexpr double kSpeedMargin = 1.5;
// Ticks come in packets: a little way may be told at once.
constexpr double kPacket = 0.005;  // m
// A standstill of the record longer than this may hide any motion at full speed.
constexpr double kLongestGap = 5.0;  // s

}  // namespace

EncoderCounters::EncoderCounters(const robot::BaseDescription& base) : base_(base) {}

std::int64_t EncoderCounters::difference(std::int32_t newer, std::int32_t older) const {
  const std::int64_t period = std::int64_t{1} << base_.counter_bits;
  std::int64_t change = (static_cast<std::int64_t>(newer) - older) % period;
  if (change >= period / 2) change -= period;
  if (change < -period / 2) change += period;
  return change;
}

double EncoderCounters::turning(double turn) {
  // A wheel that stops between two ticks may tell either: driving straight on would add up to a turn of its own.
  const double dead_band = base_.metres_per_tick() / base_.track;
  const double moved = play_ + turn;
  play_ = std::clamp(moved, -dead_band, dead_band);
  return std::abs(moved - play_);
}

std::optional<WheelMotion> EncoderCounters::motion(const EncoderReading& reading) {
  if (base_.ticks_per_turn <= 0 || !(base_.wheel_radius > 0.0) || !(base_.track > 0.0)) {
    throw std::invalid_argument("encoders of a robot whose base is not described; allowed: a robot.yaml with 'base'");
  }
  if (!last_) {
    last_ = reading;
    return std::nullopt;
  }
  if (reading.utime <= last_->utime) {
    throw std::invalid_argument("utime " + std::to_string(reading.utime) + " us is not after the last, " +
                                std::to_string(last_->utime) + "; allowed: growing times");
  }
  const double time = seconds_between(last_->utime, reading.utime);
  const double left = static_cast<double>(difference(reading.left_ticks, last_->left_ticks)) * base_.metres_per_tick();
  const double right =
      static_cast<double>(difference(reading.right_ticks, last_->right_ticks)) * base_.metres_per_tick();
  const bool restarted = reading.session != last_->session;
  last_ = reading;

  const double wheel_speed = base_.speed_max + 0.5 * base_.track * base_.turn_rate_max;
  const double most = kSpeedMargin * wheel_speed * time + kPacket;
  // After a gap so long the counters may have wrapped around unseen.
  const double half_period = 0.5 * std::ldexp(base_.metres_per_tick(), base_.counter_bits);
  const bool ambiguous = wheel_speed * time > half_period;
  const bool jumped = !restarted && std::max(std::abs(left), std::abs(right)) > most;
  if (jumped) ++jumps_;
  if (restarted || jumped || ambiguous)
    return WheelMotion{0.0, 0.0, time, base_.speed_max * std::min(time, kLongestGap)};
  const double turn = (right - left) / base_.track;
  return WheelMotion{0.5 * (left + right), turn, time, 0.0, turning(turn)};
}

}  // namespace markservo::rfid_localizer
