#pragma once

#include <atomic>
#include <cstdint>
#include <deque>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "common/time/clocks.hpp"
#include "services/stack-watch/group_device.hpp"
#include "services/stack-watch/heard.hpp"
#include "services/stack-watch/lcm_datagram.hpp"
#include "services/stack-watch/silence.hpp"
#include "services/stack-watch/supervisor/supervisor_words.hpp"

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
  ~StackWatchNode();
  StackWatchNode(const StackWatchNode&) = delete;
  StackWatchNode& operator=(const StackWatchNode&) = delete;

  // Until it is told to end (SIGINT, SIGTERM).
  void run();
  // What it knows, one JSON object: what bus-census --json prints of the last 5 to 10 s, and "watch". Any thread may
  // call.
  std::string answer();

 private:
  // What the supervisor said last.
  struct Supervised {
    std::vector<SupervisedProcess> processes;
    std::vector<RunningProcess> running;  // of them
    bool alive = false;
    bool ever_alive = false;
    std::int64_t changed_us = 0;  // wall clock: since when it is alive, or is not
    std::string why_not;
    std::string cannot_ask;  // why it was not asked last; empty where it was
  };
  struct Kill {
    std::string name;
    int pid = 0;
    double silent_s = 0.0;
    bool spoke = false;
    std::int64_t utime = 0;  // wall clock, us
  };

  void hear(const Datagram& datagram);
  void tick();
  void speak();
  void keep_bus();
  void kill_if_supervised(const SilentService& silent);
  void ask_for_processes();
  void note_answer(Supervised answer);
  std::string orphans() const;
  std::string reason(bool* well) const;

  StackWatchSettings settings_;
  std::string host_;
  std::int64_t session_;
  std::int64_t seq_ = 0;
  GroupDevice socket_;
  std::atomic<bool> ended_{false};
  std::thread asking_;

  std::mutex mutex_;  // guards all below: they are used by three threads
  Supervised supervised_;
  SilenceWatch silence_;
  RecentCensus recent_;
  std::deque<Kill> kills_;
  bool bus_was_gone_ = false;
  std::string bus_problem_;
  std::int64_t bus_changed_us_ = 0;  // wall clock
  std::int64_t crafted_ = 0;         // datagrams
  std::int64_t crafted_us_ = 0;      // wall clock, of the newest
  std::string crafted_from_;
};

}  // namespace markservo::stack_watch
