#pragma once

// One subscribed channel: raw bytes in, checked messages out, everything counted. Used by Bus only.
//
// What needs no type is in subscription.cpp: every file that subscribes compiles the rest for each of its types.

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <functional>
#include <optional>
#include <string>
#include <utility>

#include "common/bus/channel_counters.hpp"
#include "common/bus/log_not_written.hpp"
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
  virtual bool note_utime(std::int64_t utime) = 0;
  virtual std::int64_t newest_utime() const = 0;
  // How far `utime` is ahead of this host's clock, s, if further than clocks may disagree; else 0.
  virtual double ahead_of_clock(std::int64_t utime) const = 0;
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
  void note_worked_on();
  void fail_to_decode(const std::string& why);
  void refuse(const std::string& why);

  SubscriptionHost* host_;
  std::string channel_;
  ChannelCounters counters_;

 private:
  void note_refusal(const std::string& why);

  std::optional<Time> accepted_at_;
  std::optional<Time> refused_at_;
  std::string refusal_;
};

enum class Delivery {
  kLatest,  // last wins on a live bus: older messages that wait are skipped and counted
  kEach,    // every message, in order of arrival
};

// Checks, counts and orders messages of a type that its subclass knows: one that comes in, and one that waits.
class MessageSubscription : public Subscription {
 public:
  MessageSubscription(SubscriptionHost* host, std::string channel, Delivery delivery, bool exclusive)
      : Subscription(host, std::move(channel)), delivery_(delivery), exclusive_(exclusive) {}

  void receive(const void* data, std::size_t size) final;
  void dispatch() final;

 protected:
  // Of the message that comes in: decodes it, and says why not; as message_rules.hpp has it; gives its memory back.
  virtual std::string decode(const void* data, std::size_t size) = 0;
  virtual bool mend_if_it_must_be_obeyed() = 0;
  virtual std::string broken_rule() const = 0;
  virtual messages::Identity identity() const = 0;
  virtual void forget() = 0;
  // It is the one that waits from now on.
  virtual void let_wait() = 0;
  // Hands the one that waits to the handler.
  virtual void hand_over() = 0;

 private:
  void accept(bool from_the_future);

  Delivery delivery_;
  bool exclusive_;
  bool waits_ = false;
  std::int64_t waiting_utime_ = 0;
  bool on_time_line_ = false;  // the one that waits
};

template <class M>
class TypedSubscription final : public MessageSubscription {
 public:
  using Handler = std::function<void(const M&)>;

  TypedSubscription(SubscriptionHost* host, std::string channel, Delivery delivery, bool exclusive, Handler handler)
      : MessageSubscription(host, std::move(channel), delivery, exclusive), handler_(std::move(handler)) {}

 private:
  static_assert(messages::has_utime<M>::value, "a message needs the time of what it tells, int64_t utime (us)");

  std::string decode(const void* data, std::size_t size) override { return decode_into(incoming_, data, size); }
  bool mend_if_it_must_be_obeyed() override { return messages::mend_if_it_must_be_obeyed(incoming_); }
  std::string broken_rule() const override { return messages::broken_rule(incoming_); }
  messages::Identity identity() const override { return messages::identity_of(incoming_); }
  void forget() override { incoming_ = M{}; }
  void let_wait() override { std::swap(waiting_, incoming_); }
  void hand_over() override {
    M message = std::move(waiting_);
    try {
      handler_(message);
      note_worked_on();
    } catch (const LogNotWritten&) {
      // No fault of the message's: the bus stops, and says so at its end.
    } catch (const std::exception& error) {
      refuse(error.what());
    }
    incoming_ = std::move(message);
  }

  Handler handler_;
  // What is done with stays in `incoming_`: the next one takes its memory, which for a frame is megabytes.
  M incoming_{};
  M waiting_{};
};

}  // namespace markservo::bus
