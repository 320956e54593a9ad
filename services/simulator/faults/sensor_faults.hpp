#pragma once

// Faults of sensors whose time goes on: a joint or a camera that is frozen, an encoder that is stuck or reversed.
// Settings `faults.*`, 0: none. Truth stays true. No messages, no clock.

#include <cstdint>
#include <optional>

#include "services/simulator/arm/arm_command.hpp"
#include "services/simulator/base/base_rig.hpp"
#include "services/simulator/cameras/image_pair.hpp"
#include "services/simulator/faults/fault_settings.hpp"

namespace markservo::simulator {

class SensorFaults {
 public:
  // What the joints' sensors tell in place of `reading`.
  ArmReading apply(const FaultSettings& settings, ArmReading reading);
  // What the encoders' driver tells in place of `reading`; `counter_bits` as robot.yaml's base.
  OdometryReading apply(const FaultSettings& settings, int counter_bits, OdometryReading reading);
  // What the cameras show in place of `images`.
  ImagePair apply(const FaultSettings& settings, ImagePair images);

 private:
  // One wheel, as told so far: from then on only the increments count.
  struct Wheel {
    std::int32_t true_ticks = 0;
    std::int64_t ticks = 0;
    double true_distance = 0.0;
    double distance = 0.0;  // m
  };
  static void apply(std::optional<Wheel>& wheel, double factor, int counter_bits, std::int32_t& ticks,
                    double& distance);

  std::optional<double> joint_;      // rad, where the frozen one stands
  std::optional<ImagePair> images_;  // the frozen ones
  std::optional<Wheel> left_;
  std::optional<Wheel> right_;
};

}  // namespace markservo::simulator
