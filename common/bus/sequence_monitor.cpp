#include "common/bus/sequence_monitor.hpp"

#include <algorithm>

namespace markservo::bus {

void SequenceMonitor::observe(int64_t session, int64_t seq) {
  session_changed_ = session_ != 0 && session != session_;
  in_a_row_ = session == session_ ? std::min(in_a_row_ + 1, kForgotten) : 0;
  if (in_a_row_ == kForgotten) second_writer_ = false;
  if (session_changed_) {
    if (std::find(earlier_.begin(), earlier_.end(), session) != earlier_.end()) second_writer_ = true;
    earlier_.push_back(session_);
    if (earlier_.size() > kRemembered) earlier_.pop_front();
  }
  if (session != session_) {
    session_ = session;
    seq_ = seq;
    far_.reset();
    return;
  }
  follow(seq);
}

// One that comes late or twice loses nothing. One far from all others counts once the next goes on from it.
void SequenceMonitor::follow(int64_t seq) {
  const bool is_near = seq <= seq_ ? seq_ - seq <= kFar : seq - seq_ <= kFar;
  if (is_near) {
    lost_ = std::min(lost_ + sequence_gap(seq_, seq), kMaxLost);
    seq_ = std::max(seq_, seq);
    far_.reset();
    return;
  }
  const bool goes_on = far_ && seq > *far_ && seq - *far_ <= kFar;
  if (!goes_on) {
    far_ = seq;
    return;
  }
  lost_ = std::min(lost_ + sequence_gap(seq_, *far_) + sequence_gap(*far_, seq), kMaxLost);
  seq_ = seq;
  far_.reset();
}

}  // namespace markservo::bus
