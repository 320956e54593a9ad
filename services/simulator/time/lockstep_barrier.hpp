#pragma once

// Lockstep: the world stands still until every awaited channel has answered the newest frame.

#include <cstdint>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace markservo::simulator {

class LockstepBarrier {
 public:
  explicit LockstepBarrier(std::vector<std::string> channels) : channels_(std::move(channels)) {}

  // A new frame to be answered.
  void expect(std::int64_t frame_session, std::int64_t frame_seq) {
    session_ = frame_session;
    first_seq_ = last_seq_ = frame_seq;
    answered_.clear();
  }

  // The same exposure is sent again as `frame_seq`: an answer to either counts.
  void expect_also(std::int64_t frame_seq) { last_seq_ = frame_seq; }

  // An answer on `channel`; counts if it is to the expected frame.
  void observe(const std::string& channel, std::int64_t frame_session, std::int64_t frame_seq) {
    if (frame_session == session_ && frame_seq >= first_seq_ && frame_seq <= last_seq_) answered_.insert(channel);
  }

  bool complete() const { return missing().empty(); }

  // The channels still awaited, as "A, B".
  std::string missing() const {
    std::string names;
    for (const auto& channel : channels_) {
      if (answered_.count(channel) == 0) names += (names.empty() ? "" : ", ") + channel;
    }
    return names;
  }

 private:
  std::vector<std::string> channels_;
  std::int64_t session_ = 0;
  std::int64_t first_seq_ = 0;
  std::int64_t last_seq_ = 0;
  std::set<std::string> answered_;
};

}  // namespace markservo::simulator
