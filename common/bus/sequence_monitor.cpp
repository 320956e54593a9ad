#include "common/bus/sequence_monitor.hpp"

#include <algorithm>

namespace markservo::bus {

void SequenceMonitor::observe(std::int64_t session, std::int64_t seq) {
  session_changed_ = session_ != 0 && session != session_;
  in_a_row_ = session == session_ ? std::min(in_a_row_ + 1, kForgotten) : 0;
  if (in_a_row_ == kForgotten) second_writer_ = false;
  if (session_changed_) {
    if (std::find(earlier_.begin(), earlier_.end(), session) != earlier_.end()) second_writer_ = true;
    earlier_.push_back(session_);
    if (earlier_.size() > kRemembered) earlier_.erase(earlier_.begin());
  }
  if (session != session_) {
    session_ = session;
    gaps_ = GapCounter();
  }
  lost_ = std::min(lost_ + gaps_.observe(seq), kMaxLost);
}

}  // namespace markservo::bus
