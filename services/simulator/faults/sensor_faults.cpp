#include "services/simulator/faults/sensor_faults.hpp"

#include <utility>

namespace markservo::simulator {
namespace {

constexpr double kLeft = 1.0;  // of the settings that name a wheel
constexpr double kRight = 2.0;

double factor_of(const FaultSettings& settings, double wheel) {
  if (settings.stuck_encoder == wheel) return 0.0;
  return settings.reversed_encoder == wheel ? -1.0 : 1.0;
}

// From counter to counter the short way around.
std::int64_t way_around(std::int32_t from, std::int32_t to, int counter_bits) {
  const std::int64_t range = std::int64_t{1} << counter_bits;
  std::int64_t way = (std::int64_t{to} - std::int64_t{from}) % range;
  if (way >= range / 2) way -= range;
  if (way < -range / 2) way += range;
  return way;
}

std::int32_t wrapped(std::int64_t count, int counter_bits) {
  const std::int64_t range = std::int64_t{1} << counter_bits;
  return static_cast<std::int32_t>((count % range + range) % range);
}

}  // namespace

ArmReading SensorFaults::apply(const FaultSettings& settings, ArmReading reading) {
  if (settings.frozen_joint < 1.0) {
    joint_.reset();
    return reading;
  }
  const auto joint = static_cast<Eigen::Index>(settings.frozen_joint) - 1;
  if (!joint_) joint_ = reading.position[joint];
  reading.position[joint] = *joint_;
  reading.speed[joint] = 0.0;
  return reading;
}

OdometryReading SensorFaults::apply(const FaultSettings& settings, int counter_bits, OdometryReading reading) {
  apply(left_, factor_of(settings, kLeft), counter_bits, reading.ticks.left, reading.left_distance);
  apply(right_, factor_of(settings, kRight), counter_bits, reading.ticks.right, reading.right_distance);
  return reading;
}

void SensorFaults::apply(std::optional<Wheel>& wheel, double factor, int counter_bits, std::int32_t& ticks,
                         double& distance) {
  // A wheel that has always been told truly needs no counting.
  if (!wheel && factor == 1.0) return;
  if (!wheel) wheel = Wheel{ticks, ticks, distance, distance};
  wheel->ticks += static_cast<std::int64_t>(factor) * way_around(wheel->true_ticks, ticks, counter_bits);
  wheel->distance += factor * (distance - wheel->true_distance);
  wheel->true_ticks = ticks;
  wheel->true_distance = distance;
  ticks = wrapped(wheel->ticks, counter_bits);
  distance = wheel->distance;
}

ImagePair SensorFaults::apply(const FaultSettings& settings, ImagePair images) {
  if (settings.frozen_camera < 1.0) {
    images_.reset();
    return images;
  }
  // Copies: the renderer may use its memory again.
  if (!images_) images_ = ImagePair{images.left.clone(), images.right.clone()};
  return *images_;
}

}  // namespace markservo::simulator
