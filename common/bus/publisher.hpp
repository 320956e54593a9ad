#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "common/bus/outgoing.hpp"
#include "common/messages/message_rules.hpp"

namespace markservo::bus {

// What a publisher needs from the bus it belongs to, and outlives no more than that.
class MessageSink {
 public:
  virtual ~MessageSink() = default;
  // False if the network refused the bytes, which is counted; they are not kept.
  virtual bool send(const Outgoing& message) = 0;
};

// Throws std::invalid_argument that names the channel and why.
[[noreturn]] void refuse_to_publish(const std::string& channel, const std::string& why);

// Sends one type on one channel; gives streams their session and seq.
template <class M>
class Publisher {
 public:
  Publisher(MessageSink* sink, std::string channel, std::int64_t session)
      : sink_(sink), channel_(std::move(channel)), session_(session) {}

  // Fills session and seq (of types that have both), makes the texts fit and sends. Throws std::invalid_argument, and
  // sends nothing, if the message breaks its type's rules or a length field disagrees with its vector. What the network
  // refuses is counted by the bus, and missing in seq as any message lost on its way; it is not sent again.
  void publish(M& message) {
    if constexpr (messages::has_seq<M>::value) {
      message.session = session_;
      message.seq = seq_ + 1;
    }
    messages::clean_texts(message);
    if (const std::string why = messages::broken_rule(message); !why.empty()) refuse(why);
    buffer_.resize(static_cast<std::size_t>(message.getEncodedSize()));
    const int size = message.encode(buffer_.data(), 0, static_cast<int>(buffer_.size()));
    if (size < 0) refuse("a length field disagrees with its vector");
    sink_->send(
        {channel_, buffer_.data(), static_cast<std::size_t>(size), messages::identity_of(message).utime.value_or(0)});
    ++seq_;
  }

  // Leaves a number out: a message that was lost on its way, as readers will count it.
  void skip() { ++seq_; }

  std::int64_t session() const { return session_; }

 private:
  [[noreturn]] void refuse(const std::string& why) const { refuse_to_publish(channel_, why); }

  MessageSink* sink_;
  std::string channel_;
  std::int64_t session_;
  std::int64_t seq_ = 0;
  std::vector<std::uint8_t> buffer_;
};

}  // namespace markservo::bus
