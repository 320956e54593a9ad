#pragma once

#include <cstdint>
#include <string>

namespace markservo::stack_watch {

// Whether there is a bus, and since when. No clock: the caller says when.
class BusCondition {
 public:
  // `problem`: why there is none; empty where there is. `wall_us`: wall clock. Whether it went or came back.
  bool observe(const std::string& problem, std::int64_t wall_us) {
    const bool changed = problem.empty() != problem_.empty();
    problem_ = problem;
    if (changed) changed_us_ = wall_us;
    return changed;
  }

  bool is_gone() const { return !problem_.empty(); }
  const std::string& problem() const { return problem_; }
  std::int64_t changed_us() const { return changed_us_; }  // wall clock; 0: it was never gone

 private:
  std::string problem_;
  std::int64_t changed_us_ = 0;
};

}  // namespace markservo::stack_watch
