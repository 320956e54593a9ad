#include "services/mmi/world/event_log.hpp"

#include <algorithm>

#include "common/reflection/message_json.hpp"

namespace markservo::mmi {

void EventLog::add(const StateChange& change) {
  texts_.push_back(reflection::json_text(json_of(change), -1));
  if (texts_.size() <= most_) return;
  texts_.pop_front();
  ++dropped_;
}

std::string EventLog::list_after(std::int64_t number) const {
  std::string list = "[";
  const std::int64_t first = std::max(number, dropped_) - dropped_;
  for (auto i = static_cast<std::size_t>(first); i < texts_.size(); ++i) {
    if (list.size() > 1) list += ',';
    list += texts_[i];
  }
  return list + "]";
}

}  // namespace markservo::mmi
