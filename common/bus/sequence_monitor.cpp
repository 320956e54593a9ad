#include "common/bus/sequence_monitor.hpp"

#include <algorithm>

namespace markservo::bus {

void SequenceMonitor::observe(int64_t session, int64_t seq) {
  session_changed_ = session_ != 0 && session != session_;
  if (session_changed_) {
    if (std::find(earlier_.begin(), earlier_.end(), session) != earlier_.end()) second_writer_ = true;
    earlier_.push_back(session_);
    if (earlier_.size() > kRemembered) earlier_.pop_front();
  } else if (session_ != 0) {
    lost_ = std::min(lost_ + sequence_gap(seq_, seq), kMaxLost);
  }
  seq_ = session == session_ ? std::max(seq_, seq) : seq;  // one that comes late or twice loses nothing
  session_ = session;
}

}  // namespace markservo::bus
