#pragma once

// An operator's wish on the bus, sent until it is answered.
//   in:  STOP_STATE, TASK_STATE
//   out: STOP (stop, reset) or TASK_COMMAND (start, abort, home); lines of text

#include <markservo/channels.hpp>
#include <optional>
#include <string>
#include <vector>

#include "common/bus/service.hpp"
#include "common/motion/command_sender.hpp"
#include "common/motion/sole_writer.hpp"
#include "services/task-operator/dialogue.hpp"

namespace markservo::task_operator {

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
  // On which bus nobody answered, for people.
  static std::string where(const bus::Bus& bus);

  // What the options ask for.
  struct Wish {
    std::string action;
    std::string target;
    std::vector<double> drive;  // x and y (m), heading (degrees); empty: stand
    bool carry = false;
    std::string source = "task-operator";
  };

  Wish wish_;
  Action action_ = Action::kStop;
  Parameters parameters_;

  std::optional<Dialogue> dialogue_;
  std::optional<motion::CommandSender> sender_;
  motion::SoleWriter task_{"TASK_STATE"};
  bus::Bus* bus_ = nullptr;
  std::optional<bus::Publisher<StopRequest>> stops_;
  std::optional<bus::Publisher<TaskCommand>> commands_;
  int exit_code_ = kExitReached;
};

}  // namespace markservo::task_operator
