#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <string>

#include "services/base-navigator/navigator_types.hpp"

namespace markservo::base_navigator {

struct OdometryParameters {
  double track = 0.0;          // m, between the wheels' middles
  double wheel_speed = 0.0;    // m/s; a wheel that seems twice as fast has not moved: its counter has jumped
  double jump = 0.03;          // m, allowed on top of that
  double gap = 0.3;            // s; after a longer silence nothing is known of the way in between
  double kept = 1.5;           // s of history
  double speed_window = 0.06;  // s; over one 20 ms period the encoders' ticks alone make 0.04 rad/s
};

// Where the wheels say the robot went: X_OR, in a frame O that is where the track began.
class OdometryTrack {
 public:
  // What it says is wrong with the sample, or an empty text. A sample that is not newer is not taken; one that comes
  // after a jump of the counters or a gap begins a new track (see epoch()).
  std::string add(const OdometryParameters& parameters, const OdometrySample& sample);
  // The next sample begins a new track: it is another base's, or of another time.
  void forget();

  bool empty() const { return history_.empty(); }
  // What was wrong with the newest sample, taken or not; empty when nothing was.
  const std::string& problem() const { return problem_; }
  // us, the earliest that any sample told since the beginning; 0 before.
  std::int64_t first_utime() const { return first_utime_; }
  std::int64_t newest_utime() const { return history_.empty() ? 0 : history_.back().utime; }
  // s, from the sample before to the newest one; 0 at a track's beginning.
  double step() const;
  geometry::PlanePose newest() const { return history_.empty() ? geometry::PlanePose() : history_.back().X_OR; }
  // Between two samples by interpolation; up to `beyond` s before or after all by the end. None when it is not known.
  std::optional<geometry::PlanePose> at(std::int64_t utime, double beyond) const;
  double speed() const { return speed_; }          // m/s, forward
  double turn_rate() const { return turn_rate_; }  // rad/s, counter-clockwise
  // The number of the frame O, another one for every new O: what was seen in an earlier one cannot be placed any more.
  int epoch() const { return epoch_; }

 private:
  struct Entry {
    std::int64_t utime;
    double left;
    double right;
    geometry::PlanePose X_OR;
  };

  std::string accept(const OdometryParameters& parameters, const OdometrySample& sample);
  void begin(const OdometrySample& sample);
  void measure_speed(const OdometryParameters& parameters);

  std::deque<Entry> history_;
  int epoch_ = 0;
  double speed_ = 0.0;
  double turn_rate_ = 0.0;
  std::int64_t first_utime_ = 0;
  std::string problem_;
};

}  // namespace markservo::base_navigator
