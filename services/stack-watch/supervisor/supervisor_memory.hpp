#pragma once

// What is known of the stack's supervisor and of what it runs. No clock, no process: the caller tells what was answered
// and when.

#include <cstdint>
#include <string>
#include <vector>

#include "services/stack-watch/silence.hpp"
#include "services/stack-watch/supervisor/supervisor_words.hpp"

namespace markservo::stack_watch {

// What came of asking once.
struct SupervisorAnswer {
  std::vector<SupervisedProcess> processes;
  std::vector<RunningProcess> running;  // of them
  bool alive = false;
  std::string why_not;     // alive; empty where it is
  std::string cannot_ask;  // why it was not asked, which says nothing of it; empty where it was
};

class SupervisorMemory {
 public:
  enum class News { kNone, kCannotBeAsked, kDied, kAnswers };

  // `wall_us`: wall clock. One that is busy for a moment, or cannot be asked, makes nobody forget who runs: its last
  // word counts until the next.
  News observe(SupervisorAnswer answer, std::int64_t wall_us);

  // One that never answered may still be starting.
  bool is_dead() const { return !newest_.alive && ever_alive_; }
  bool is_alive() const { return newest_.alive; }
  std::int64_t changed_us() const { return changed_us_; }  // wall clock: since when it is alive, or is not; 0: ever
  const std::string& why_not() const { return newest_.why_not; }
  const std::string& cannot_ask() const { return newest_.cannot_ask; }  // as it was last

  const std::vector<SupervisedProcess>& processes() const { return newest_.processes; }
  const std::vector<RunningProcess>& running() const { return newest_.running; }

 private:
  SupervisorAnswer newest_;  // but for what was remembered
  bool ever_alive_ = false;
  std::int64_t changed_us_ = 0;
};

}  // namespace markservo::stack_watch
