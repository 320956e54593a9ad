#pragma once

// One trial's hold on the running stack: it hears the bus, keeps the history, sends, watches processes, runs scripts,
// and lets the faults that are at work do so while it waits.

#include <chrono>
#include <cstdint>
#include <deque>
#include <functional>
#include <map>
#include <markservo/ServiceStatus.hpp>
#include <markservo/SimBaseTruth.hpp>
#include <markservo/SimTruth.hpp>
#include <markservo/StopState.hpp>
#include <markservo/TaskState.hpp>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "tests/system/fault_campaign/child.hpp"
#include "tests/system/fault_campaign/history.hpp"
#include "tests/system/fault_campaign/message_leaves.hpp"
#include "tests/system/fault_campaign/multicast_bus.hpp"
#include "tests/system/fault_campaign/stack_processes.hpp"

namespace markservo::campaign {

struct BenchFolders {
  std::string repository;
  std::string build;    // has bin/SERVICE
  std::string out;      // of the trial
  std::string runtime;  // of its stack
};

inline constexpr std::uint16_t kPort = 7667;  // LCM's own: the private network is the trial's

// A message of the stack's, kept whole.
struct KeptMessage {
  std::int64_t t = 0;  // us
  std::string channel;
  Bytes data;
};

class Bench {
 public:
  explicit Bench(BenchFolders folders);

  // us, of this host's wall clock.
  static std::int64_t now();
  const BenchFolders& folders() const { return folders_; }
  HistoryWriter& history() { return history_; }
  void fact(nlohmann::json fact) { history_.fact(now(), std::move(fact)); }

  // Listens for `seconds`, or until `done`; false when the time ran out first.
  bool listen(double seconds, const std::function<bool()>& done = {});
  // Called every few milliseconds while the bench listens.
  void set_task(std::function<void()> task) { task_ = std::move(task); }
  // Called with each whole message at once; `own`: the trial sent it, not the stack.
  using Listener = std::function<void(const KeptMessage& message, bool own)>;
  void add_listener(Listener listener) { listeners_.push_back(std::move(listener)); }

  // Sends as nobody of the stack, and says so in the history.
  bool send(const std::string& channel, const Bytes& data);
  bool send_datagram(const Bytes& bytes) { return bus_.send_datagram(bytes); }
  // Passes on what a service of the stack wrote elsewhere: it counts as the stack's.
  bool pass_on(const std::string& channel, const Bytes& data) { return bus_.send(channel, data); }
  std::int64_t refused() const { return bus_.refused(); }
  // How many of what was sent came back.
  std::int64_t own_heard() const { return own_heard_; }

  // Runs a program while listening; its exit code, 124 after `patience_s`. What it prints is kept as printed/NAME.
  int run(const std::string& name, const std::vector<std::string>& command, double patience_s = 60.0);
  std::unique_ptr<Child> start(const std::string& name, const std::vector<std::string>& command);
  std::string printed(const std::string& name) const;
  // scripts/stack of this trial, and more words.
  std::vector<std::string> stack_command(const std::string& action, const std::vector<std::string>& more = {}) const;

  // The service's process, 0 when there is none.
  int pid_of(const std::string& service);

  // What the stack itself said last.
  const SimTruth& truth() const { return truth_; }
  const SimBaseTruth& base_truth() const { return base_truth_; }
  const TaskState& task() const { return task_state_; }
  const std::map<std::string, StopState>& stop_states() const { return stop_states_; }
  // Services whose newest word, no older than `age` s, is that they are ready.
  std::set<std::string> ready(double age = 3.0) const;
  const KeptMessage* last_heard(const std::string& channel) const;
  // The last `kKept` of the stack's messages, and all of STOP and TASK_COMMAND, whoever sent those.
  const std::deque<KeptMessage>& kept() const { return kept_; }
  std::int64_t heard_count(const std::string& channel) const;
  bool own_session(const std::string& service, std::int64_t session) const;

  static const std::vector<std::string>& services();

 private:
  static constexpr std::size_t kKept = 4000;

  void hear(const HeardMessage& message);
  void learn(const KeptMessage& message);
  void sample_processes();

  BenchFolders folders_;
  MulticastBus bus_;
  HistoryWriter history_;
  std::function<void()> task_;
  std::vector<Listener> listeners_;
  std::deque<std::pair<std::int64_t, std::size_t>> own_;  // when and which bytes were sent, by their hash
  std::int64_t own_heard_ = 0;
  std::map<std::string, std::vector<ServiceProcess>> processes_;
  std::set<int> pids_;  // all that were ever the stack's
  std::map<std::string, std::set<std::int64_t>> sessions_;
  std::set<int> spoken_;
  std::int64_t sampled_ = 0;
  SimTruth truth_{};
  SimBaseTruth base_truth_{};
  TaskState task_state_{};
  std::map<std::string, StopState> stop_states_;
  std::map<std::string, std::pair<std::int64_t, ServiceStatus>> statuses_;
  std::map<std::string, KeptMessage> last_;
  std::map<std::string, std::int64_t> counts_;
  std::deque<KeptMessage> kept_;
};

}  // namespace markservo::campaign
