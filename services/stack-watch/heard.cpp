#include "services/stack-watch/heard.hpp"

#include <utility>

namespace markservo::stack_watch {

void RecentCensus::observe(const census::KnownProcesses& known) {
  known_ = known;
  older_.observe(known);
  newer_.observe(known);
}

void RecentCensus::observe(const census::Heard& message) {
  older_.observe(message);
  newer_.observe(message);
}

void RecentCensus::observe(const census::ServiceWord& word, Instant now) {
  older_.observe(word, now.wall_us);
  newer_.observe(word, now.wall_us);
  const Process process{word.name, word.host, word.pid};
  if (states_.size() >= kMaxProcesses && states_.count(process) == 0 && !known_.have(word)) return;
  State& state = states_[process];
  if (state.heard_us == 0 || state.state != word.state) {
    state.state = word.state;
    state.since_us = now.wall_us;
  }
  state.heard_us = now.steady_us;
}

void RecentCensus::step(Instant now) {
  if (now.steady_us - turned_us_ < kSpan_us) return;
  turned_us_ = now.steady_us;
  older_ = std::exchange(newer_, census::Census(now.wall_us));
  newer_.observe(known_);
  for (auto state = states_.begin(); state != states_.end();) {
    state = now.steady_us - state->second.heard_us > kForgotten_us ? states_.erase(state) : std::next(state);
  }
}

std::optional<std::int64_t> RecentCensus::state_since_us(const census::ServiceWord& word) const {
  const auto state = states_.find({word.name, word.host, word.pid});
  if (state == states_.end()) return std::nullopt;
  return state->second.since_us;
}

}  // namespace markservo::stack_watch
