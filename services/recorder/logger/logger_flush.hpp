#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace markservo::recorder {

struct FlushParameters {
  // For what is on its way into the queue.
  std::int64_t queue_us = 300'000;
  // On top of it, where the kernel does not tell in which function a thread waits.
  std::int64_t blind_us = 700'000;
  // A disk that takes longer has failed.
  std::int64_t patience_us = 30'000'000;
};

// In which of the kernel's functions the threads of lcm-logger wait ("0": the kernel does not tell).
struct LoggerThreads {
  std::string main;
  std::optional<std::string> writer;  // its second thread, which writes; nothing where there is none
};

// When an lcm-logger may be told to end: it drops what is still queued then, so it is let write that first.
class LoggerFlush {
 public:
  // `told_us`: when its end was asked for, of a clock that nobody sets.
  explicit LoggerFlush(std::int64_t told_us, FlushParameters parameters = {})
      : parameters_(parameters), told_us_(told_us) {}

  // Whether nothing is queued any more, told from where its threads wait at `now_us`; also when the disk has failed. To
  // be called again and again until then.
  bool has_written(const LoggerThreads& threads, std::int64_t now_us);

 private:
  FlushParameters parameters_;
  std::int64_t told_us_;
  std::optional<bool> blind_;
};

}  // namespace markservo::recorder
