#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "services/recorder/folder/recording_folder.hpp"
#include "services/recorder/logger/kept_logger.hpp"
#include "services/recorder/logger/logger_words.hpp"
#include "services/recorder/logger/restart_pace.hpp"
#include "services/recorder/recording_plan.hpp"
#include "services/recorder/signal_queue.hpp"

namespace markservo::recorder {

// The lcm-loggers behind a recording, one after the other: each writes a part, or, with --split-mb, several.
class LoggerRuns {
 public:
  // All must outlive this.
  LoggerRuns(const RecordingPlan& plan, const RecordingFolder& folder, SignalQueue& signals)
      : plan_(plan), folder_(folder), signals_(signals) {}

  // Starts the next one and waits until it listens; false when it ended, or hears nothing, instead.
  bool begin();
  // How long to wait before the next one begins, us, where the last has died.
  std::int64_t pause_us();

  bool is_alive() { return logger_ && logger_->is_alive(); }
  // Ends it, where it lives, when it has written what it holds; then there is none. How it ended.
  LoggerEnd end();

  // False when the interface that the group was joined on is gone: whoever joined it there hears nothing any more, and
  // is not told.
  bool can_hear();

  // Since when the last one listens, until when it could hear, and since when what was said is on no disk: us since the
  // epoch.
  std::int64_t listens_since() const { return listens_since_; }
  std::int64_t heard_until() const { return heard_until_; }
  std::int64_t missed_since() const;

  const LoggerWords& words();

 private:
  void start();
  bool await_listening();
  void await_its_last_event();

  const RecordingPlan& plan_;
  const RecordingFolder& folder_;
  SignalQueue& signals_;
  std::optional<KeptLogger> logger_;
  LoggerWords words_;
  RestartPace pace_;
  int runs_ = 0;
  std::int64_t started_us_ = 0;
  std::int64_t listens_since_ = 0;
  std::int64_t heard_until_ = 0;
  std::optional<int> interface_;
};

}  // namespace markservo::recorder
