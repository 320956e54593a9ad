#pragma once

// One subscribed channel whose messages are passed on as bytes: counted, not decoded. Used by Bus only.

#include <cstddef>
#include <exception>
#include <functional>
#include <string>
#include <utility>

#include "common/bus/subscription.hpp"

namespace markservo::bus {

class RawSubscription final : public Subscription {
 public:
  using Handler = std::function<bool(const void* data, std::size_t size)>;

  RawSubscription(SubscriptionHost* host, std::string channel, Handler handler)
      : Subscription(host, std::move(channel)), handler_(std::move(handler)) {}

  void receive(const void* data, std::size_t size) override {
    note_arrival();
    try {
      const bool used = handler_(data, size);
      note_accepted();
      note_worked_on();
      if (!used) ++counters_.skipped;
    } catch (const std::exception& error) {
      refuse(error.what());
    }
  }

  // Nothing is left to be done: receive() has passed the message on.
  void dispatch() override {}

 private:
  Handler handler_;
};

}  // namespace markservo::bus
