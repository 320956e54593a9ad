#include "services/simulator/base/wheel_encoder.hpp"

#include <cmath>

namespace markservo::simulator {

std::int32_t WheelEncoder::counter() const {
  const std::int64_t count = first_count_ + turned();
  const std::int64_t range = std::int64_t{1} << counter_bits_;
  const std::int64_t positive = ((count % range) + range) % range;
  return static_cast<std::int32_t>(static_cast<std::uint32_t>(positive));
}

std::int64_t WheelEncoder::turned() const {
  return static_cast<std::int64_t>(std::floor(way_ / tick_));
}

}  // namespace markservo::simulator
