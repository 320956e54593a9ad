#pragma once

#include <lcm/lcm-cpp.hpp>

#include "common/bus/publisher.hpp"

namespace markservo::bench {

// Publishers' way to the bus without a bus::Bus, which would listen too. `lcm` must outlive this.
class LcmSink final : public bus::MessageSink {
 public:
  explicit LcmSink(lcm::LCM* lcm) : lcm_(lcm) {}
  bool send(const bus::Outgoing& message) override {
    return lcm_->publish(message.channel, message.data, static_cast<unsigned int>(message.size)) >= 0;
  }

 private:
  lcm::LCM* lcm_;
};

}  // namespace markservo::bench
