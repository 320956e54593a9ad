#pragma once

// One subscribed channel: raw bytes in, checked messages out, everything counted. Used by Bus only.

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <functional>
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
  // Something came, whatever it is: the bus is not deaf.
  virtual void note_traffic() = 0;
  // A checked message of `utime` came in. True if that lies on the time line of the bus.
  virtual bool note_utime(int64_t utime) = 0;
  virtual int64_t newest_utime() const = 0;
  // How far `utime` is ahead of this host's clock, s, if further than clocks may disagree; else 0.
  virtual double ahead_of_clock(int64_t utime) const = 0;
  // Logs at most once a second per channel.
  virtual void complain(const std::string& channel, const std::string& what) = 0;
  // Every event is handled as it comes: replaying a log.
  virtual bool replaying() const = 0;
};

class Subscription {
 public:
  using Time = std::chrono::steady_clock::time_point;

  Subscription(SubscriptionHost* host, std::string channel) : host_(host), channel_(std::move(channel)) {}
  virtual ~Subscription() = default;
  Subscription(const Subscription&) = delete;
  Subscription& operator=(const Subscription&) = delete;

  // Takes one event off the wire.
  virtual void receive(const void* data, std::size_t size) = 0;
  // Hands over the newest message, if one waits.
  virtual void dispatch() = 0;

  const std::string& channel() const { return channel_; }
  const ChannelCounters& counters() const { return counters_; }
  // When a message last came and could be worked on, by this host's steady clock; nothing before the first.
  std::optional<Time> accepted_at() const { return accepted_at_; }
  // When one last was refused, and why.
  std::optional<Time> refused_at() const { return refused_at_; }
  const std::string& refusal() const { return refusal_; }

 protected:
  void note_arrival() { host_->note_traffic(); }
  void note_accepted() { ++counters_.received; }
  void note_worked_on() { accepted_at_ = std::chrono::steady_clock::now(); }
  void fail_to_decode(const std::string& why) {
    ++counters_.decode_failures;
    note_refusal(why);
  }
  void refuse(const std::string& why) {
    ++counters_.refused;
    note_refusal(why);
  }

  SubscriptionHost* host_;
  std::string channel_;
  ChannelCounters counters_;

 private:
  void note_refusal(const std::string& why) {
    refused_at_ = std::chrono::steady_clock::now();
    refusal_ = why;
    host_->complain(channel_, why);
  }

  std::optional<Time> accepted_at_;
  std::optional<Time> refused_at_;
  std::string refusal_;
};

// "3600 s" or "0.25 s": as coarse as it may be told again and again.
inline std::string ahead_text(double seconds) {
  char text[32];
  std::snprintf(text, sizeof text, seconds < 10.0 ? "%.2g s" : "%.0f s", seconds);
  return text;
}

enum class Delivery {
  kLatest,  // last wins on a live bus: older messages that wait are skipped and counted
  kEach,    // every message, in order of arrival
};

template <class M>
class TypedSubscription final : public Subscription {
 public:
  using Handler = std::function<void(const M&)>;

  TypedSubscription(SubscriptionHost* host, std::string channel, Delivery delivery, bool exclusive, Handler handler)
      : Subscription(host, std::move(channel)),
        delivery_(delivery),
        exclusive_(exclusive),
        handler_(std::move(handler)) {}

  void receive(const void* data, std::size_t size) override {
    note_arrival();
    M message = std::move(spare_);
    if (const std::string why = decode_into(message, data, size); !why.empty()) {
      spare_ = M{};  // what a bad message claimed to need is given back
      return fail_to_decode(why);
    }
    const bool obeyed = messages::mend_if_it_must_be_obeyed(message);
    if (const std::string why = obeyed ? "" : messages::broken_rule(message); !why.empty()) return refuse(why);
    const double ahead = host_->ahead_of_clock(message.utime);
    if (ahead > 0.0 && !obeyed) {
      return refuse("utime is " + ahead_text(ahead) + " ahead of this host's clock; allowed: at most 20 ms");
    }
    accept(std::move(message), ahead > 0.0);
  }

  void dispatch() override {
    if (!waiting_) return;
    M message = std::move(*waiting_);
    waiting_.reset();
    if (on_time_line_) {
      counters_.latency.add(1e-6 * static_cast<double>(host_->newest_utime() - message.utime),
                            std::chrono::steady_clock::now());
    }
    try {
      handler_(message);
      note_worked_on();
    } catch (const std::exception& error) {
      refuse(error.what());
    }
    spare_ = std::move(message);
  }

 private:
  void accept(M&& message, bool from_the_future) {
    note_accepted();
    if constexpr (messages::has_seq<M>::value) {
      if (exclusive_) counters_.sequence.observe(message.session, message.seq);
    }
    // A stop of an unknown time or a wrong one tells nothing about it.
    on_time_line_ = message.utime != 0 && !from_the_future && host_->note_utime(message.utime);
    if (on_time_line_) counters_.newest_utime = message.utime;
    if (waiting_) {
      ++counters_.skipped;
      spare_ = std::move(*waiting_);
    }
    waiting_ = std::move(message);
    if (delivery_ == Delivery::kEach || host_->replaying()) dispatch();
  }

  Delivery delivery_;
  bool exclusive_;
  Handler handler_;
  std::optional<M> waiting_;
  bool on_time_line_ = false;  // the one that waits
  M spare_{};  // a message that is done with: the next one takes its memory, which for a frame is megabytes
};

}  // namespace markservo::bus
