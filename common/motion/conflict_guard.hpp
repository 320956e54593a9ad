#pragma once

// What a reader does when two claim to be one: it holds, asks for a STOP until what moves is latched, and goes on only
// when a RESET that came after has released it and one alone is heard.
//
// | state    | event                        | then                                   |
// | -------- | ---------------------------- | -------------------------------------- |
// | quiet    | raise                        | stopping: STOP is due, under a new id  |
// | stopping | latched, after STOP was sent | stopped                                |
// | stopped  | released, one alone          | quiet                                  |
// | stopped  | released, two still speak    | stopping, under a new id               |
// | any but quiet | another is the device, and released | stopping, under a new id    |

#include <cstdint>
#include <optional>
#include <string>

namespace markservo::motion {

// A STOP that the reader itself asks for: StopRequest's request_id and reason.
struct StopWish {
  std::int64_t id = 0;
  std::string reason;
};

class ConflictGuard {
 public:
  enum class State { kQuiet, kStopping, kStopped };

  // Two claim to be one; `why` names channel and sessions.
  void raise(const std::string& why);

  // To be called when another one is the device from now on, and not latched: it may never have heard the STOP.
  void ask_again() {
    if (active()) ask();
  }

  // The device's STOP_STATE; `alone`: on every watched channel one session alone is heard. True when the conflict ends.
  bool hear_stop_state(bool latched, bool alone);

  // The STOP to send at `now` (us, the device's time): at once, then at 5 Hz.
  std::optional<StopWish> due(std::int64_t now);

  bool active() const { return state_ != State::kQuiet; }
  State state() const { return state_; }
  // Why nothing moves; empty while quiet.
  const std::string& why() const { return why_; }

 private:
  void ask();

  State state_ = State::kQuiet;
  std::string why_;
  std::int64_t id_ = 0;
  bool sent_ = false;
  std::int64_t sent_at_ = 0;  // us
};

}  // namespace markservo::motion
