#pragma once

#include <mutex>
#include <optional>
#include <string>

#include "common/time/clocks.hpp"
#include "services/stack-watch/bus_condition.hpp"
#include "services/stack-watch/group_device.hpp"
#include "services/stack-watch/heard.hpp"
#include "services/stack-watch/incidents.hpp"
#include "services/stack-watch/own_word_message.hpp"
#include "services/stack-watch/process_word_messages.hpp"
#include "services/stack-watch/silence.hpp"
#include "services/stack-watch/supervisor/periodic_supervisor_reader.hpp"
#include "services/stack-watch/supervisor/supervisor_memory.hpp"

namespace markservo::stack_watch {

inline Instant now() {
  return {wall_clock_us(), steady_clock_us()};
}

struct StackWatchSettings {
  std::string url;         // of the bus
  std::string robot;       // prefix of its own SERVICE_STATUS
  std::string supervisor;  // supervisord's socket
  SilenceParameters silence;
};

// Listens to the bus beside a stack, and kills what has fallen silent, for the supervisor to start it again.
class StackWatchNode {
 public:
  // Throws ConfigurationError.
  explicit StackWatchNode(StackWatchSettings settings);
  StackWatchNode(const StackWatchNode&) = delete;
  StackWatchNode& operator=(const StackWatchNode&) = delete;

  // Until it is told to end (SIGINT, SIGTERM).
  void run();
  // What it knows, one JSON object: what bus-census --json prints of the last 5 to 10 s, and "watch". Any thread may
  // call.
  std::string answer();

 private:
  void on_datagram(const Datagram& datagram);
  void step();
  void speak();
  void speak_of_processes(Telling telling);
  void keep_bus();
  void kill_if_silent(const SilentService& silent);
  void note_answer(SupervisorAnswer answer);
  std::string trouble() const;
  std::string reason() const;

  StackWatchSettings settings_;
  GroupDevice socket_;

  std::mutex mutex_;  // guards those up to reader_: they are used by three threads
  OwnWord word_;
  SupervisorMemory supervisor_;
  SilenceWatch silence_;
  RecentCensus recent_;
  Kills kills_;
  ProcessWordMessages process_words_;
  BusCondition bus_;
  CraftedFragments crafted_;

  std::optional<PeriodicSupervisorReader> reader_;  // the last one: it ends before what its thread uses
};

}  // namespace markservo::stack_watch
