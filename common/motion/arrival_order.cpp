#include "common/motion/arrival_order.hpp"

#include <algorithm>

#include "common/time/seconds_between.hpp"

namespace markservo::motion {

Arrival ArrivalOrder::hear(const Stamp& stamp) {
  if (empty_) return accept(stamp, Arrival::kNext);
  const bool number_grew = stamp.seq > last_.seq;
  if (stamp.utime > last_.utime && !number_grew) return out_of_turn(stamp, Arrival::kDouble);
  if (number_grew && stamp.utime >= last_.utime) return accept(stamp, Arrival::kNext);
  const bool far_back = seconds_between(stamp.utime, last_.utime) > parameters_.clock_step;
  if (far_back) return number_grew ? accept(stamp, Arrival::kAnew) : Arrival::kLate;
  return out_of_turn(stamp, taken_otherwise(stamp) ? Arrival::kDouble : Arrival::kLate);
}

Arrival ArrivalOrder::out_of_turn(const Stamp& stamp, Arrival verdict) {
  const bool goes_on = run_ > 0 && stamp.seq > run_last_.seq && stamp.utime > run_last_.utime;
  run_ = goes_on ? run_ + 1 : 1;
  run_last_ = stamp;
  return run_ >= parameters_.run ? accept(stamp, Arrival::kAnew) : verdict;
}

bool ArrivalOrder::taken_otherwise(const Stamp& stamp) const {
  return std::any_of(taken_.begin(), taken_.end(), [&stamp](const Stamp& taken) {
    const bool says_other = taken.content != 0 && stamp.content != 0 && taken.content != stamp.content;
    return taken.seq == stamp.seq && (taken.utime != stamp.utime || says_other);
  });
}

Arrival ArrivalOrder::accept(const Stamp& stamp, Arrival arrival) {
  if (arrival == Arrival::kAnew) taken_.clear();
  taken_.push_back(stamp);
  if (taken_.size() > kTaken) taken_.pop_front();
  empty_ = false;
  last_ = stamp;
  run_ = 0;
  return arrival;
}

}  // namespace markservo::motion
