#pragma once

// An operator's wish on the bus, sent until it is answered.
//   in:  STOP_STATE, TASK_STATE; SERVICE_STATUS, to say who is there when nobody answers
//   out: STOP (stop, reset) or TASK_COMMAND (start, abort, home); lines of text

#include <markservo/channels.hpp>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "common/bus/service.hpp"
#include "common/motion/command_sender.hpp"
#include "common/motion/sole_writer.hpp"
#include "common/task/dialogue.hpp"
#include "common/text/typed_command.hpp"

namespace markservo::task_operator {

// What was asked for, as the options say it.
struct Wish {
  std::string action_text;
  task::Action action = task::Action::kStop;
  std::string target;
  std::vector<double> place;  // drive: x and y (m), heading (degrees)
  std::vector<double> drive;  // start: likewise; empty: stand
  bool carry = false;
  std::string source = "task-operator";
};

class TaskOperatorNode : public bus::Service {
 public:
  // `program`: the first argument of the command line.
  explicit TaskOperatorNode(const std::string& program = {});

  void add_options(CLI::App& app) override;
  void configure(const std::string& robot_file) override;
  // A person waits for it.
  bool waits_for_network() const override { return false; }
  void start(bus::Bus& bus) override;
  void run(bus::Bus& bus) override;

  // How it ended; kExitReached while it has not, kExitInterrupted when it was told to end before there was an answer.
  int exit_code() const { return exit_code_; }

 private:
  void on_stop_state(const StopState& state);
  void on_task_state(const TaskState& state);
  void send();
  void tell(const task::Ending& ending) const;

  text::TypedCommand typed_;
  Wish wish_;
  task::Parameters parameters_;

  std::optional<task::Dialogue> dialogue_;
  std::optional<motion::CommandSender> sender_;
  motion::SoleWriter task_{"TASK_STATE"};
  bus::Bus* bus_ = nullptr;
  std::set<std::string> services_;  // the others that are on the bus
  std::optional<bus::Publisher<StopRequest>> stops_;
  std::optional<bus::Publisher<TaskCommand>> commands_;
  int exit_code_ = task::kExitReached;
};

}  // namespace markservo::task_operator
