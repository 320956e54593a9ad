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
  // The pair of file time `first_us` is due at `start_us`.
  Schedule(std::int64_t start_us, std::int64_t first_us, std::int64_t period_us)
      : shift_us_(start_us - first_us), period_us_(period_us) {}

  // When the pair of file time `time_us` is due, us; call once per pair with the clock's present reading.
  std::int64_t due(std::int64_t time_us, std::int64_t now_us);

 private:
  std::int64_t shift_us_;
  std::int64_t period_us_;
};

}  // namespace markservo::stereo_camera
