#pragma once

// When the pairs of a file are published and which time they carry.

#include <cstdint>

namespace markservo::stereo_camera {

inline constexpr std::int64_t kLogEpoch_us = 1'600'000'000'000'000;  // of pairs written to a log: the same in every run

// n periods after `start_us` at `rate_hz` (above 0), us.
std::int64_t time_of(std::int64_t start_us, std::int64_t n, double rate_hz);

// Paces a file's pairs on a live bus. A reader that falls behind by more than a period moves the schedule instead of
// sending a burst of old pairs.
class Schedule {
 public:
  Schedule(std::int64_t start_us, double rate_hz) : start_us_(start_us), rate_hz_(rate_hz) {}

  // When pair `index` is due, us; call once per pair with the clock's present reading.
  std::int64_t due(std::int64_t index, std::int64_t now_us);

 private:
  std::int64_t start_us_;
  double rate_hz_;
};

}  // namespace markservo::stereo_camera
