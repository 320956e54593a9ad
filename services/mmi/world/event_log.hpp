#pragma once

#include <cstdint>
#include <deque>
#include <string>

#include "services/mmi/scene/state_change.hpp"

namespace markservo::mmi {

// The changes of state as texts in JSON, numbered without a gap; the oldest go when there are too many.
class EventLog {
 public:
  explicit EventLog(std::size_t most) : most_(most) {}

  void add(const StateChange& change);

  // Of the newest; 0: none yet.
  std::int64_t newest() const { return dropped_ + static_cast<std::int64_t>(texts_.size()); }
  // Whether all after `number` are still here.
  bool has_all_after(std::int64_t number) const { return number >= dropped_; }
  // All after `number` that are still here, as a JSON list.
  std::string list_after(std::int64_t number) const;

 private:
  std::size_t most_;
  std::deque<std::string> texts_;
  std::int64_t dropped_ = 0;
};

}  // namespace markservo::mmi
