#include "common/motion/arrival_order.hpp"

#include "common/time/seconds_between.hpp"

namespace markservo::motion {

Arrival ArrivalOrder::judge(const Stamp& stamp) {
  if (empty_) return take(stamp, Arrival::kNext);
  const bool number_grew = stamp.seq > last_.seq;
  if (stamp.utime > last_.utime && !number_grew) return out_of_turn(stamp, Arrival::kDouble);
  if (number_grew && stamp.utime >= last_.utime) return take(stamp, Arrival::kNext);
  const bool far_back = seconds_between(stamp.utime, last_.utime) > parameters_.clock_step;
  if (far_back) return number_grew ? take(stamp, Arrival::kAnew) : Arrival::kLate;
  return out_of_turn(stamp, Arrival::kLate);
}

Arrival ArrivalOrder::out_of_turn(const Stamp& stamp, Arrival verdict) {
  const bool goes_on = run_ > 0 && stamp.seq > run_last_.seq && stamp.utime > run_last_.utime;
  run_ = goes_on ? run_ + 1 : 1;
  run_last_ = stamp;
  return run_ >= parameters_.run ? take(stamp, Arrival::kAnew) : verdict;
}

Arrival ArrivalOrder::take(const Stamp& stamp, Arrival arrival) {
  empty_ = false;
  last_ = stamp;
  run_ = 0;
  return arrival;
}

}  // namespace markservo::motion
