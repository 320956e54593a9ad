#pragma once

// What the wheels said, kept long enough to go back to the time of a read.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <deque>

#include "common/time/seconds_between.hpp"

namespace markservo::rfid_localizer {

// Motion of the robot over a short time, as the wheels tell it.
struct WheelMotion {
  double way = 0.0;          // m, forward, of the middle between the wheels
  double turn = 0.0;         // rad, counter-clockwise
  double time = 0.0;         // s
  double unknown_way = 0.0;  // m, how far the robot may have gone besides, when a piece of the record is missing
  double turning = 0.0;      // rad, of `turn` and against it added up, without what the ticks' jitter pretends
};

class WheelHistory {
 public:
  static constexpr std::int64_t kKept_us = 8'000'000;  // longer than any reader's delay

  // Adds the motion since the last sample, which ended at `utime` (us, after the last). The first sample begins the
  // record; its motion is ignored.
  void add(std::int64_t utime, const WheelMotion& motion);
  void forget() { samples_.clear(); }

  bool empty() const { return samples_.empty(); }
  std::int64_t newest() const { return samples_.back().utime; }  // us
  std::int64_t oldest() const { return samples_.front().utime; }

  // Calls `use(motion)` for each piece of the way from `from` to `to` (us), in order; a part of an unknown way has its
  // share of the variance. Before the record begins nothing is known to move; after its end the last piece goes on for
  // at most kExtrapolation_us.
  template <class Use>
  void replay(std::int64_t from, std::int64_t to, Use use) const {
    if (samples_.size() < 2 || to <= from) return;
    const auto ends_later = [](std::int64_t utime, const Sample& sample) { return utime < sample.utime; };
    const auto first_piece = std::upper_bound(samples_.begin() + 1, samples_.end() - 1, from, ends_later);
    for (auto i = static_cast<std::size_t>(first_piece - samples_.begin()); i < samples_.size(); ++i) {
      if (samples_[i - 1].utime >= to) return;
      const std::int64_t begin = samples_[i - 1].utime;
      std::int64_t end = samples_[i].utime;
      if (i + 1 == samples_.size()) end += kExtrapolation_us;
      const std::int64_t first = from > begin ? from : begin;
      const std::int64_t last = to < end ? to : end;
      if (last <= first) continue;
      const double share = static_cast<double>(last - first) / static_cast<double>(samples_[i].utime - begin);
      const WheelMotion& motion = samples_[i].motion;
      use(WheelMotion{motion.way * share, motion.turn * share, seconds_between(first, last),
                      motion.unknown_way * std::sqrt(share), motion.turning * share});
    }
  }

  // m/s and rad/s on average from `from` to `to` (us); zero where nothing is known.
  WheelMotion rate(std::int64_t from, std::int64_t to) const;

 private:
  static constexpr std::int64_t kExtrapolation_us = 200'000;

  struct Sample {
    std::int64_t utime;
    WheelMotion motion;  // since the one before
  };
  std::deque<Sample> samples_;
};

}  // namespace markservo::rfid_localizer
