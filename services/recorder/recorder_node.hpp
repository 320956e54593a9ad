#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "services/recorder/folder/recording_folder.hpp"
#include "services/recorder/logger/logger_runs_node.hpp"
#include "services/recorder/manifest/manifest.hpp"
#include "services/recorder/recorder_options.hpp"
#include "services/recorder/recorder_status_node.hpp"
#include "services/recorder/recording_end.hpp"
#include "services/recorder/signal_queue.hpp"

namespace markservo::recorder {

// Records the bus into a folder until there is a reason to end.
class RecorderNode {
 public:
  // `options` and `signals` must outlive this. Makes the folder and takes it for itself. Throws Refusal.
  RecorderNode(const RecorderOptions& options, SignalQueue& signals);

  // The exit code. Throws Refusal: then nothing was recorded and nothing is left behind.
  int run();

 private:
  void check_disk();
  void begin_manifest();
  void join_bus();
  void warn_of_small_buffer() const;
  void give_up_if_told();
  void watch();
  std::optional<EndReason> reason_to_end();
  bool resume();
  bool rejoin();
  bool go_on_after(std::int64_t from_utime, const LoggerEnd& end, const std::string& reason);
  bool begin_again(const std::string& why);
  void remove_old_parts();
  void show_progress() const;
  void tell(bool recording, const std::string& why);
  int finish();
  int report(const LoggerEnd& logger);
  std::int64_t recorded_us() const;

  const RecorderOptions& options_;
  SignalQueue& signals_;
  RecordingFolder folder_;
  LoggerRuns runs_;
  std::optional<RecorderStatusNode> word_;  // once there is a bus
  Json manifest_;
  std::int64_t began_us_ = 0;  // of a clock that nobody sets
  std::int64_t free_mb_ = 0;
  int removed_ = 0;  // parts
  int interruptions_ = 0;
  std::optional<EndReason> ended_by_;
  std::optional<LoggerEnd> failed_as_;  // lcm-logger, where it ended the recording
};

}  // namespace markservo::recorder
