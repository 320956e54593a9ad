#include "services/mmi/scene/state_changes.hpp"

#include <limits>
#include <utility>

namespace markservo::mmi {
namespace {

constexpr std::int64_t kFirstSession = std::numeric_limits<std::int64_t>::min();

std::string text_of(const Saying& saying, const std::string& state_before, bool again) {
  std::string text = saying.subject.empty() ? "" : saying.subject + ": ";
  if (again) text += "began again: ";
  const bool moved = !state_before.empty() && state_before != saying.state;
  if (saying.kind == ChangeKind::kTask && moved) text += state_before + " -> ";
  return text + saying.state + saying.detail;
}

}  // namespace

std::optional<StateChange> StateChanges::observe(const Report& report, std::int64_t at, double now) {
  if (const std::optional<Saying> saying = saying_of(report)) return compare(*saying, at, now);
  std::optional<Request> request = request_of(report);
  if (!request || !requests_.is_new(request->channel, request->session, request->id)) return std::nullopt;
  if (!may_tell_request(now)) {
    ++untold_;
    return std::nullopt;
  }
  return tell({0, at, std::move(request->channel), "", ChangeKind::kCommand, std::move(request->state),
               std::move(request->text), request->level});
}

bool StateChanges::may_tell_request(double now) {
  while (!requests_told_.empty() && now - requests_told_.front() >= 1.0) requests_told_.pop_front();
  if (requests_told_.size() >= parameters_.requests_told) return false;
  requests_told_.push_back(now);
  return true;
}

StateChange StateChanges::tell(StateChange change) {
  change.number = ++number_;
  return change;
}

std::optional<StateChange> StateChanges::compare(const Saying& saying, std::int64_t at, double now) {
  const Writer writer(saying.kind, saying.key, saying.session);
  const Word word{saying.state, saying.gist, now};
  const auto same = [&](const Word& other) { return other.state == word.state && other.gist == word.gist; };
  std::string state_before;
  bool again = false;
  if (const auto known = words_.find(writer); known != words_.end()) {
    const Word before = std::exchange(known->second, word);
    if (same(before)) return std::nullopt;
    state_before = before.state;
  } else {
    if (!make_room(saying.kind, now)) {
      ++untold_;
      return std::nullopt;
    }
    const Word* predecessor = newest_of(saying.kind, saying.key);
    const bool repeats = predecessor != nullptr && same(*predecessor);
    again = predecessor != nullptr && saying.kind == ChangeKind::kService;
    if (predecessor != nullptr) state_before = predecessor->state;
    words_.emplace(writer, word);
    if (repeats && !again) return std::nullopt;
  }
  return tell({0, at, saying.channel, saying.key, saying.kind, saying.state, text_of(saying, state_before, again),
               again && saying.level == Level::kInfo ? Level::kWarning : saying.level});
}

const StateChanges::Word* StateChanges::newest_of(ChangeKind kind, const std::string& key) const {
  const Word* newest = nullptr;
  for (auto entry = words_.lower_bound({kind, key, kFirstSession}); entry != words_.end(); ++entry) {
    if (std::get<ChangeKind>(entry->first) != kind || std::get<std::string>(entry->first) != key) break;
    if (newest == nullptr || entry->second.heard >= newest->heard) newest = &entry->second;
  }
  return newest;
}

bool StateChanges::make_room(ChangeKind kind, double now) {
  std::size_t number = 0;
  auto quietest = words_.end();
  for (auto entry = words_.lower_bound({kind, "", kFirstSession}); entry != words_.end(); ++entry) {
    if (std::get<ChangeKind>(entry->first) != kind) break;
    ++number;
    if (quietest == words_.end() || entry->second.heard < quietest->second.heard) quietest = entry;
  }
  if (number < parameters_.writers_max) return true;
  if (now - quietest->second.heard < parameters_.quiet) return false;
  words_.erase(quietest);
  return true;
}

}  // namespace markservo::mmi
