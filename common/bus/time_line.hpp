#pragma once

#include <cstdint>

namespace markservo::bus {

// Follows the utime of all messages that a bus accepts: "now" as the messages have it. One that lies is not believed:
// a jump of more than a second either way counts once three messages in a row agree with it, as after a silence, a
// restart or a clock that was set.
class TimeLine {
 public:
  // Takes the next message's utime, us. True if it lies on the time line: near its newest, or the third that agrees.
  bool observe(std::int64_t utime);

  // us; 0 before the first message.
  std::int64_t newest() const { return newest_; }

 private:
  bool started_ = false;
  std::int64_t newest_ = 0;
  std::int64_t other_ = 0;  // where messages elsewhere are
  int in_a_row_ = 0;        // so many of them, without one on the time line between
};

}  // namespace markservo::bus
