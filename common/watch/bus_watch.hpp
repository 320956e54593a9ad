#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "common/channel_pattern/channel_pattern.hpp"
#include "common/watch/channel_watch.hpp"

namespace markservo::watch {

// All channels of a bus, each with its newest message where that is asked for. No clock: `now` is seconds of any clock
// that does not go back.
class BusWatch {
 public:
  struct Channel {
    ChannelWatch watch;
    std::vector<std::uint8_t> newest;  // payload; empty where none is kept
  };

  enum class Keeps { kNewest, kFigures };

  // `keeps`: whether each channel's newest message is copied.
  explicit BusWatch(Keeps keeps = Keeps::kNewest) : keeps_(keeps) {}

  // Channels beyond the first kMaxChannels are counted only.
  void observe(const std::string& channel, const reflection::MessageNote& note, const void* data, double now);

  const std::map<std::string, Channel>& channels() const { return channels_; }
  const Channel* find(const std::string& channel) const;  // null: never heard
  // The channels heard that `text`, a ChannelPattern, stands for: of that name, else those whose names it takes.
  std::vector<std::string> matching(const std::string& text, const ChannelPattern& pattern) const;
  // Messages on channels that are not watched because there are too many.
  std::int64_t unwatched() const { return unwatched_; }

  static constexpr std::size_t kMaxChannels = 1000;  // whoever writes on more means harm

 private:
  Keeps keeps_;
  std::map<std::string, Channel> channels_;
  std::int64_t unwatched_ = 0;
};

}  // namespace markservo::watch
