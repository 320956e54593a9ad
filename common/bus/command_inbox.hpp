#pragma once

#include <cstdint>
#include <map>

namespace markservo::bus {

// Commands are repeated until they are echoed, and executed once: remembers the last id of each sender.
// Ids of one session grow; an older one that arrives late is not executed any more.
class CommandInbox {
 public:
  // True the first time (session, id) is seen; it then is the one to echo.
  bool accept(int64_t session, int64_t id) {
    auto [entry, first] = last_id_.try_emplace(session, id);
    if (!first) {
      if (id <= entry->second) return false;
      entry->second = id;
    }
    session_ = session;
    id_ = id;
    return true;
  }

  // What to echo: the last accepted command; 0 before the first.
  int64_t session() const { return session_; }
  int64_t id() const { return id_; }

 private:
  std::map<int64_t, int64_t> last_id_;
  int64_t session_ = 0;
  int64_t id_ = 0;
};

}  // namespace markservo::bus
