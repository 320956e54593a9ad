#pragma once

#include <cstdint>
#include <lcm/lcm-cpp.hpp>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "common/messages/message_rules.hpp"

namespace markservo::bus {

// Sends one type on one channel; gives streams their session and seq.
template <class M>
class Publisher {
 public:
  Publisher(lcm::LCM* lcm, std::string channel, int64_t session)
      : lcm_(lcm), channel_(std::move(channel)), session_(session) {}

  // Fills session and seq (of types that have both), makes the texts fit and sends. Throws std::invalid_argument, and
  // sends nothing, if the message breaks its type's rules or a length field disagrees with its vector;
  // std::runtime_error if the bus refuses.
  void publish(M& message) {
    if constexpr (messages::has_seq<M>::value) {
      message.session = session_;
      message.seq = seq_ + 1;
    }
    messages::clean_texts(message);
    if (const std::string why = messages::broken_rule(message); !why.empty()) {
      throw std::invalid_argument("publish on " + channel_ + ": " + why);
    }
    buffer_.resize(static_cast<std::size_t>(message.getEncodedSize()));
    const int size = message.encode(buffer_.data(), 0, static_cast<int>(buffer_.size()));
    if (size < 0) throw std::invalid_argument("publish on " + channel_ + ": a length field disagrees with its vector");
    if (lcm_->publish(channel_, buffer_.data(), static_cast<unsigned int>(size)) < 0) {
      throw std::runtime_error("publish on " + channel_ + ": the bus refused the message");
    }
    ++seq_;
  }

  // Leaves a number out: a message that was lost on its way, as readers will count it.
  void skip() { ++seq_; }

  int64_t session() const { return session_; }

 private:
  lcm::LCM* lcm_;
  std::string channel_;
  int64_t session_;
  int64_t seq_ = 0;
  std::vector<uint8_t> buffer_;
};

}  // namespace markservo::bus
