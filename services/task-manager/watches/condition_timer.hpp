#pragma once

#include <cstdint>
#include <optional>

#include "common/time/seconds_between.hpp"

namespace markservo::task_manager {

// How long something has been so without a break.
class ConditionTimer {
 public:
  // s until `now` (us), at which it is so or not; 0 when it is not, or the clock was set back since it began.
  double observe(bool is_so, std::int64_t now) {
    if (!is_so) since_.reset();
    if (is_so && (!since_ || now < *since_)) since_ = now;
    return is_so ? seconds_between(*since_, now) : 0.0;
  }

 private:
  std::optional<std::int64_t> since_;  // us
};

}  // namespace markservo::task_manager
