#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <deque>

namespace markservo::bus {

// Commands are repeated until they are echoed, and executed once: remembers the last id of each of the last 64 senders.
// Ids of one session grow; an older one that arrives late is not executed any more.
class CommandInbox {
 public:
  // True the first time (session, id) is seen; it then is the one to echo.
  bool accept(int64_t session, int64_t id) {
    const auto entry = std::find_if(senders_.begin(), senders_.end(),
                                    [session](const Sender& sender) { return sender.session == session; });
    if (entry != senders_.end()) {
      if (id <= entry->last_id) return false;
      senders_.erase(entry);
    }
    senders_.push_back({session, id});
    if (senders_.size() > kSenders) senders_.pop_front();
    session_ = session;
    id_ = id;
    return true;
  }

  // What to echo: the last accepted command; 0 before the first.
  int64_t session() const { return session_; }
  int64_t id() const { return id_; }

 private:
  static constexpr std::size_t kSenders = 64;
  struct Sender {
    int64_t session;
    int64_t last_id;
  };

  std::deque<Sender> senders_;  // the one that spoke last at the end
  int64_t session_ = 0;
  int64_t id_ = 0;
};

}  // namespace markservo::bus
