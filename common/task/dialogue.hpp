#pragma once

// What an operator's wish is, until the robot has answered it: when to send, what to tell, how it ended. Times are
// seconds of any steady clock.

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "common/states/task_phase.hpp"

namespace markservo::task {

enum class Action { kStart, kAbort, kHome, kStop, kReset, kDrive };

using Phase = TaskPhase;

// What STOP_STATE says of one device.
struct StopReport {
  std::string device;
  bool latched = false;
  bool answers_us = false;  // the last request it obeyed is ours
  std::string reason;
};

enum class Answers { kNobody, kUs, kAnother };

// What TASK_STATE says.
struct TaskReport {
  double time = 0.0;                   // s, of the message
  Answers answers = Answers::kNobody;  // whose command was executed last
  Phase phase = Phase::kIdle;
  int attempt = 0;
  std::string target;
  std::string reason;
};

inline constexpr int kExitReached = 0;        // lifted, done, home, arrived, aborted, stopped, reset
inline constexpr int kExitRefused = 1;        // refused, failed or stopped: the line says why
inline constexpr int kExitNoAnswer = 4;       // the line says who
inline constexpr int kExitInterrupted = 130;  // told to end before there was an answer, as a shell tells Ctrl-C

struct Ending {
  int exit_code = kExitReached;
  std::string line;
};

struct Step {
  bool send = false;               // the request, now
  std::vector<std::string> lines;  // to print
  std::optional<Ending> ending;
};

struct Parameters {
  double patience = 5.0;                 // s without an answer; devices and task speak at 5 Hz or more
  double repeat = 0.2;                   // s between two sendings: LCM may lose one
  std::string command = "scripts/task";  // what a person types, for the words that name it
};

// STOP is sent at once and its reset once every stop device has spoken, until every one has answered; ABORT at once,
// until the task has. START, HOME and DRIVE wait until stop devices and task have spoken, are not sent while a stop is
// latched or a task is under way, and are followed until the task ends.
class Dialogue {
 public:
  Dialogue(Action action, std::vector<std::string> stop_devices, Parameters parameters = {});

  void observe(const StopReport& report);
  void observe(const TaskReport& report, double now);
  // Two answer as one: nothing that either says can be believed. `words` name them.
  void observe_conflict(const std::string& words) { two_ = words; }

  // Whether the task has answered, and is followed to its end.
  bool followed() const { return followed_.has_value(); }

  // What to do at `now`; to be called every 0.1 s or oftener, and no more after an ending.
  Step step(double now);

 private:
  bool for_devices() const { return action_ == Action::kStop || action_ == Action::kReset; }
  bool moves() const;
  std::optional<Ending> devices_ending() const;
  std::optional<Ending> obstacle() const;
  std::optional<Ending> task_ending() const;
  std::optional<Ending> silence(double now) const;
  std::string silent_devices() const;
  void send_if_due(double now, Step& step);

  // The task that answers us.
  struct FollowedTask {
    double since = 0.0;              // s of the messages
    std::optional<TaskReport> told;  // last
  };

  Action action_;
  std::vector<std::string> stop_devices_;
  Parameters parameters_;

  std::map<std::string, StopReport> devices_;
  std::optional<TaskReport> task_;
  std::optional<double> task_heard_;  // when
  std::optional<FollowedTask> followed_;
  bool clear_ = false;  // nothing is in the request's way
  std::string two_;
  std::optional<double> began_;  // the current wait
  std::optional<double> sent_;
  std::vector<std::string> lines_;  // to print at the next step
};

}  // namespace markservo::task
