#pragma once

#include <cstdint>

namespace markservo::recorder {

// The signals that come to this process, taken when it looks: SIGINT, SIGTERM, SIGHUP and SIGQUIT tell it to end,
// SIGCHLD that a child has ended. Those that were ignored when the process began stay so (a shell's background job
// ignores Ctrl-C). To be made once, before any thread and any child.
class SignalQueue {
 public:
  // Throws std::system_error.
  SignalQueue();
  ~SignalQueue();
  SignalQueue(const SignalQueue&) = delete;
  SignalQueue& operator=(const SignalQueue&) = delete;

  // Whether the process was told to end, now or before.
  bool told();

  // Waits so long, us, or until a signal comes or, where one is given, `descriptor` has something to be read.
  void wait(std::int64_t timeout_us, int descriptor = -1);

 private:
  void take();

  int descriptor_ = -1;
  bool told_ = false;
};

}  // namespace markservo::recorder
