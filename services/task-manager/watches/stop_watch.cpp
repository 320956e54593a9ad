#include "services/task-manager/watches/stop_watch.hpp"

#include <utility>

namespace markservo::task_manager {

std::optional<Ending> StopWatch::observe(const StopReport& stop, Phase phase, bool waits_for_first_word) {
  const bool known_before = std::exchange(was_known_, stop.known);
  const bool latched_before = std::exchange(was_latched_, stop.latched);
  was_reset_ = (latched_before || stop.meanwhile) && !stop.latched;

  const bool fell_silent = known_before && !stop.known;
  if (fell_silent && under_way(phase) && phase != Phase::kLook && !waits_for_first_word) {
    return Ending{Phase::kStopped, "a stop device is silent: no STOP_STATE of " + stop.silent};
  }
  const bool first_word = !known_before && waits_for_first_word;
  const bool stopped = stop.latched || (stop.meanwhile && !first_word);
  if (!stopped || !stop_ends(phase)) return std::nullopt;
  if (first_word) return Ending{Phase::kRefused, describe_latched(stop)};
  return Ending{Phase::kStopped, "stop: " + (stop.latched ? stop.reason : "it is reset by now")};
}

}  // namespace markservo::task_manager
