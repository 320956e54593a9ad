#pragma once

#include <cstddef>
#include <lcm/lcm-cpp.hpp>
#include <string>

#include "common/bus/publisher.hpp"

namespace markservo::bench {

// Publishers' way to the bus without a bus::Bus, which would listen too. `lcm` must outlive this.
class LcmSink final : public bus::MessageSink {
 public:
  explicit LcmSink(lcm::LCM* lcm) : lcm_(lcm) {}
  bool send(const std::string& channel, const void* data, std::size_t size) override {
    return lcm_->publish(channel, data, static_cast<unsigned int>(size)) >= 0;
  }

 private:
  lcm::LCM* lcm_;
};

}  // namespace markservo::bench
