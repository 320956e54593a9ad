#include "services/recorder/logger/logger_flush.hpp"

namespace markservo::recorder {

bool LoggerFlush::has_written(const LoggerThreads& threads, std::int64_t now_us) {
  const std::int64_t waited_us = now_us - told_us_ - parameters_.queue_us;
  if (waited_us < 0) return false;
  // What the main thread does in between says nothing: it runs, or waits for messages.
  if (!blind_) blind_ = threads.main == "0";
  if (*blind_) return waited_us >= parameters_.blind_us;
  if (!threads.writer) return true;
  const bool waits_for_the_queue = threads.writer->find("futex") != std::string::npos;
  return waits_for_the_queue || waited_us >= parameters_.patience_us;
}

}  // namespace markservo::recorder
