#pragma once

// A history, decoded and put in order: who wrote what when, and how the world's own time went on meanwhile. The checker
// knows nothing else.

#include <cstdint>
#include <map>
#include <markservo/BaseCommand.hpp>
#include <markservo/BaseGoal.hpp>
#include <markservo/BaseStatus.hpp>
#include <markservo/JointCommand.hpp>
#include <markservo/ServiceStatus.hpp>
#include <markservo/ServoGoal.hpp>
#include <markservo/ServoStatus.hpp>
#include <markservo/SimBaseTruth.hpp>
#include <markservo/SimTruth.hpp>
#include <markservo/StopRequest.hpp>
#include <markservo/StopState.hpp>
#include <markservo/TaskCommand.hpp>
#include <markservo/TaskState.hpp>
#include <set>
#include <string>
#include <vector>

#include "tests/system/fault_campaign/history.hpp"
#include "tests/system/fault_campaign/world_clock.hpp"

namespace markservo::campaign {

template <class M>
struct Heard {
  std::int64_t t = 0;    // us, when it was heard
  double world = 0.0;    // s, of WorldClock
  bool foreign = false;  // the trial's own
  M message{};
};

template <class M>
using Stream = std::vector<Heard<M>>;

// How much came on a channel.
struct Traffic {
  std::int64_t t = 0;
  std::int64_t size = 0;  // bytes
  bool foreign = false;
  std::int64_t texts = 0;    // bytes of it that are texts; of a message that was cut, unknown: 0
  std::int64_t longest = 0;  // bytes of its longest text
};

struct ProcessSample {
  std::int64_t t = 0;  // us
  int pid = 0;
  char state = '?';  // as in /proc/PID/stat
  double rss_mb = 0.0;
};

struct Fault {
  std::string what;               // for people
  std::set<std::string> words;    // channels and processes that a reason may name
  std::int64_t struck_at = 0;     // us; 0: it never struck
  std::int64_t ended_at = 0;      // us
  std::set<std::string> excuses;  // invariants that it makes impossible to judge
};

struct Timeline {
  Stream<SimTruth> truth;           // the stack's own simulator's only
  Stream<SimBaseTruth> base_truth;  // likewise
  Stream<JointCommand> joint_commands;
  Stream<BaseCommand> base_commands;
  Stream<ServoGoal> servo_goals;
  Stream<BaseGoal> base_goals;
  Stream<ServoStatus> servo_statuses;
  Stream<BaseStatus> base_statuses;
  Stream<StopRequest> stops;
  Stream<StopState> stop_states;
  Stream<TaskCommand> task_commands;
  Stream<TaskState> task_states;
  Stream<ServiceStatus> statuses;
  std::map<std::string, std::vector<Traffic>> traffic;          // by channel
  std::map<std::string, std::vector<ProcessSample>> processes;  // the stack's, by service
  std::map<std::string, std::set<std::int64_t>> sessions;       // by service: what its processes wrote under
  std::vector<Fault> faults;
  std::vector<std::int64_t> task_starts;  // us, START commands of the trial's own
  std::string target;                     // of them
  std::vector<nlohmann::json> recordings;
  std::map<std::string, std::string> printed;
  std::int64_t ended_at = 0;  // us, of the trial: what was heard while its stack was taken down is left out
  WorldClock clock;

  // From the first strike on; the trial's end where nothing struck.
  std::int64_t first_strike() const;
  // When the last fault was gone; the trial's end where one never went.
  std::int64_t faults_gone() const;
  // Whether messages may have been lost around `t`: a fault of the network strikes, or one just went.
  bool loses_messages(std::int64_t t) const;
  // Whether somebody flooded the bus in the second before `t`, so that sockets overflow.
  bool flooded(std::int64_t t) const;
  bool is(const std::string& service, std::int64_t session) const;
  // The task's state at `t` by the stack's own word; -1 before the first.
  int task_state_at(std::int64_t t) const;
};

Timeline timeline_of(const History& history);

}  // namespace markservo::campaign
