#pragma once

// Logs made of whole events, for tests.

#include <cstdint>
#include <markservo/StopState.hpp>
#include <markservo/TargetPose.hpp>
#include <random>
#include <string>
#include <vector>

#include "common/logs/log_format.hpp"
#include "tests/unit/encoded.hpp"

namespace markservo::logs {

struct OwnedEvent {
  std::int64_t number = 0;
  std::int64_t utime = 0;
  std::string channel;
  std::string data;

  LogEvent view() const {
    return {number, utime, channel, {reinterpret_cast<const std::uint8_t*>(data.data()), data.size()}};
  }
  bool operator==(const OwnedEvent& other) const {
    return number == other.number && utime == other.utime && channel == other.channel && data == other.data;
  }
};

inline ByteView view_of(const std::string& bytes) {
  return {reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()};
}

template <class M>
std::string payload(const M& message) {
  const auto bytes = test::encoded(message);
  return {bytes.begin(), bytes.end()};
}

inline TargetPose target_pose(std::int64_t utime, std::int64_t session, std::int64_t seq, double x = 0.0) {
  TargetPose pose{};
  pose.utime = utime;
  pose.session = session;
  pose.seq = seq;
  pose.num_marks = 1;
  pose.marks.resize(1);
  pose.marks[0].name = "book";
  pose.marks[0].p_C.x = x;
  return pose;
}

inline std::string log_bytes(const std::vector<OwnedEvent>& events) {
  std::string bytes;
  for (const OwnedEvent& event : events) bytes += encoded(event.view());
  return bytes;
}

inline std::vector<LogEvent> views(const std::vector<OwnedEvent>& events) {
  std::vector<LogEvent> all;
  for (const OwnedEvent& event : events) all.push_back(event.view());
  return all;
}

// Messages of ours and of unknown types, small and large, as a logger would write them.
inline std::vector<OwnedEvent> mixed_events(int count, std::mt19937& random) {
  std::vector<OwnedEvent> events;
  for (int i = 0; i < count; ++i) {
    OwnedEvent event;
    event.number = i;
    event.utime = 1'700'000'000'000'000 + std::int64_t{10'000} * i;
    if (i % 3 == 0) {
      event.channel = "TARGET_POSE";
      event.data = payload(target_pose(event.utime, 7, i / 3 + 1, 0.001 * i));
    } else {
      event.channel = i % 3 == 1 ? "OTHERS" : "BIG";
      event.data.resize(i % 3 == 1 ? 20 + random() % 200 : 2000 + random() % 8000);
      for (char& byte : event.data) byte = static_cast<char>(random());
    }
    events.push_back(std::move(event));
  }
  return events;
}

}  // namespace markservo::logs
