#pragma once

// Which frames the cameras expose, and when. Counted in the world's steps and in frames since the last restart; `seq`
// is the number that a frame has on the bus, another one each time that it is sent.

#include <cstdint>

#include "services/simulator/cameras/frame_schedule.hpp"

namespace markservo::simulator {

class Exposures {
 public:
  // The first frame is due at `first_step`.
  Exposures(double rate_hz, std::int64_t first_step);

  // Begins anew: the next frame is due at `first_step` and is number 1.
  void begin_anew(double rate_hz, std::int64_t first_step);
  // Takes another rate at `step`, counted from the last exposure.
  void change_rate(double rate_hz, std::int64_t step);

  bool due(std::int64_t step) const { return step >= schedule_.next(); }

  // Exposes a frame at `step` and sends it as `seq`. Repeated at the same step it is the same frame.
  void expose(std::int64_t step, std::int64_t seq);

  // Number of the exposed frame since the beginning; 0 before the first.
  std::int64_t number() const { return number_; }
  // The number of the frame that was sent as `seq`, were there one frame a seq up to the exposed one.
  std::int64_t number_of(std::int64_t seq) const;

  // Whether the exposed frame is one of the share `drop_rate` that is lost: the same in every run with `seed`.
  bool lost(std::uint64_t seed, double drop_rate) const;

 private:
  FrameSchedule schedule_;
  std::int64_t number_ = 0;
  std::int64_t first_seq_ = 0;  // of the exposed frame, as first sent
  std::int64_t exposed_step_ = -1;
};

}  // namespace markservo::simulator
