#pragma once

// One subscribed channel: raw bytes in, checked messages out, everything counted. Used by Bus only.

#include <cstdint>
#include <functional>
#include <lcm/lcm-cpp.hpp>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "common/bus/channel_counters.hpp"
#include "common/bus/safe_decode.hpp"
#include "common/messages/message_rules.hpp"

namespace markservo::bus {

// What a subscription needs from the bus it belongs to.
class SubscriptionHost {
 public:
  virtual ~SubscriptionHost() = default;
  // A checked message of `utime` came in; `new_session` when its writer restarted.
  virtual void note_utime(int64_t utime, bool new_session) = 0;
  virtual int64_t newest_utime() const = 0;
  // True if `utime` is further ahead of this host's clock than clocks may disagree.
  virtual bool from_the_future(int64_t utime) const = 0;
  // Logs at most once a second per channel.
  virtual void complain(const std::string& channel, const std::string& what) = 0;
  // Every event is handled as it comes: replaying a log.
  virtual bool replaying() const = 0;
};

class Subscription {
 public:
  explicit Subscription(std::string channel) : channel_(std::move(channel)) {}
  virtual ~Subscription() = default;
  Subscription(const Subscription&) = delete;
  Subscription& operator=(const Subscription&) = delete;

  // Takes one event off the wire.
  virtual void receive(const void* data, std::size_t size) = 0;
  // Hands over the newest message, if one waits.
  virtual void dispatch() = 0;

  const std::string& channel() const { return channel_; }
  const ChannelCounters& counters() const { return counters_; }

 protected:
  std::string channel_;
  ChannelCounters counters_;
};

enum class Delivery {
  kLatest,  // last wins on a live bus: older messages that wait are skipped and counted
  kEach,    // every message, in order of arrival
};

template <class M>
class TypedSubscription final : public Subscription {
 public:
  using Handler = std::function<void(const M&)>;

  TypedSubscription(SubscriptionHost* host, std::string channel, Delivery delivery, bool exclusive, Handler handler)
      : Subscription(std::move(channel)),
        host_(host),
        delivery_(delivery),
        exclusive_(exclusive),
        handler_(std::move(handler)) {}

  void receive(const void* data, std::size_t size) override {
    M message = std::move(spare_);
    if (const std::string why = decode_into(message, data, size); !why.empty()) {
      spare_ = M{};  // what a bad message claimed to need is given back
      ++counters_.decode_failures;
      host_->complain(channel_, why);
      return;
    }
    if (!messages::mend_if_it_must_be_obeyed(message)) {
      if (const std::string why = messages::broken_rule(message); !why.empty()) return refuse(why);
      if (host_->from_the_future(message.utime)) {
        return refuse("utime " + std::to_string(message.utime) +
                      " us is ahead of this host's clock; allowed: at most 20 ms");
      }
    }
    accept(std::move(message));
  }

  void dispatch() override {
    if (!waiting_) return;
    M message = std::move(*waiting_);
    waiting_.reset();
    counters_.latency.add(1e-6 * static_cast<double>(host_->newest_utime() - message.utime));
    try {
      handler_(message);
    } catch (const std::exception& error) {
      refuse(error.what());
    }
    spare_ = std::move(message);
  }

 private:
  void refuse(const std::string& why) {
    ++counters_.refused;
    host_->complain(channel_, why);
  }

  void accept(M&& message) {
    ++counters_.received;
    if constexpr (messages::has_seq<M>::value) {
      if (exclusive_) counters_.sequence.observe(message.session, message.seq);
    }
    counters_.newest_utime = message.utime;
    host_->note_utime(message.utime, counters_.sequence.session_changed());
    if (waiting_) {
      ++counters_.skipped;
      spare_ = std::move(*waiting_);
    }
    waiting_ = std::move(message);
    if (delivery_ == Delivery::kEach || host_->replaying()) dispatch();
  }

  SubscriptionHost* host_;
  Delivery delivery_;
  bool exclusive_;
  Handler handler_;
  std::optional<M> waiting_;
  M spare_{};  // a message that is done with: the next one takes its memory, which for a frame is megabytes
};

}  // namespace markservo::bus
