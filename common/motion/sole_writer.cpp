#include "common/motion/sole_writer.hpp"

#include <algorithm>
#include <cmath>

#include "common/time/seconds_between.hpp"

namespace markservo::motion {

std::string two_write(const std::string& what, std::int64_t one, std::int64_t other) {
  if (one == other) return "two write " + what + " with one session: " + std::to_string(one);
  return "two write " + what + ": sessions " + std::to_string(one) + " and " + std::to_string(other);
}

StreamHeard SoleWriter::hear(const Stamp& stamp, std::int64_t now) {
  if (now == 0) now = stamp.utime;
  if (session_ == 0) session_ = stamp.session;
  if (stamp.session != session_) return hear_another(stamp, now);
  const Arrival arrival = order_.hear(stamp);
  if (arrival == Arrival::kLate) return StreamHeard::kLate;
  heard_at_ = now;
  if (arrival == Arrival::kDouble) {
    other_ = Other{stamp.session, stamp.utime, now, true};
    return StreamHeard::kSecond;
  }
  // What was under way when another took over may arrive after the other's first word.
  if (other_ && stamp.utime > other_->first_utime) {
    const bool over = other_->told && alone(now);
    other_->told = true;
    if (!over) return StreamHeard::kSecond;
    other_.reset();
    return StreamHeard::kAnew;
  }
  return arrival == Arrival::kAnew ? StreamHeard::kAnew : StreamHeard::kTaken;
}

StreamHeard SoleWriter::hear_another(const Stamp& stamp, std::int64_t now) {
  heard_at_ = std::min(heard_at_, now);  // a clock that went back tells nothing of how long the floor was free
  if (seconds_between(heard_at_, now) <= parameters_.floor) {
    if (!other_ || other_->session != stamp.session) other_ = Other{stamp.session, stamp.utime, now, false};
    other_->heard_at = now;
    return StreamHeard::kWaits;
  }
  const bool returns = former_ && former_->session == stamp.session && stamp.utime > former_->first_utime &&
                       std::abs(seconds_between(former_->heard_at, now)) <= parameters_.gone;
  former_ = Other{session_, stamp.utime, now, true};
  session_ = stamp.session;
  heard_at_ = now;
  other_.reset();
  if (returns) other_ = former_;
  order_.forget();
  order_.hear(stamp);
  return returns ? StreamHeard::kSecond : StreamHeard::kAnew;
}

bool SoleWriter::alone(std::int64_t now) const {
  return !other_ || std::abs(seconds_between(other_->heard_at, now)) > parameters_.alone;
}

}  // namespace markservo::motion
