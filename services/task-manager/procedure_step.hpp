#pragma once

// One step of the procedure, at work. Private to procedure.cpp, drive.cpp and phases.cpp.

#include "services/task-manager/approach_plan.hpp"
#include "services/task-manager/procedure.hpp"

namespace markservo::task_manager {

class ProcedureStep {
 public:
  ProcedureStep(const robot::RobotDescription& robot, const Parameters& parameters, const Input& input, State& state,
                Output& output)
      : robot_(robot), p_(parameters), in_(input), s_(state), out_(output) {}

  // procedure.cpp: what may happen in any phase.
  void run();

 private:
  void watch_the_clock();
  void pass_over(std::int64_t pause_us);
  void watch_the_arm();
  void watch_the_stop_devices();
  void watch_the_servo();
  void insist_on_rest();
  void watch_the_hand();
  void hear(const Command& command);
  void execute(const Command& command);
  void start(const Command& command);
  void home();
  std::string why_no_task(const Command& command) const;

  void enter(Phase phase, const std::string& reason);
  void enter_stage(int stage, const std::string& reason);
  void refuse(const std::string& reason);
  void fail(const std::string& reason);
  void stop(const std::string& reason);
  void send(Goal goal);
  void hold();
  bool holds_something() const;
  void play(const std::vector<Move>& moves);
  void send_move();
  bool way_is_done();
  double closed_opening() const;
  double waited() const { return seconds_between(s_.since, in_.utime); }
  const robot::MarkDescription& target() const { return *robot_.find_mark(s_.task.target); }
  const robot::ArmDescription& arm() const { return *robot_.arm; }
  MarkReport sight_of(const std::string& name) const;

  // drive.cpp: before figure 11.
  void drive();
  void make_ready();
  void drive_to(bool from_robot, const geometry::PlanePose& pose);
  void watch_the_drive();
  bool corrects_the_stand(const std::string& trouble);
  bool may_drive() const;
  bool waits_for_first_word() const;
  void send(DriveGoal goal);
  void command_the_base();

  // phases.cpp: figure 11.
  void run_phase();
  void look();
  void decide();
  void not_taken(const std::string& reason);
  std::string who_is_silent() const;
  void tell_why_unseen();
  void approach();
  void begin_servo(int stage);
  void servo();
  void grip();
  void lift();
  void verify();
  void lift_on();
  void carry();
  void release();
  void go_home();
  bool average_both_marks();
  std::string unseen_marks() const;
  void back_off(const std::string& failure);
  void grip_failed(const std::string& failure);

  const robot::RobotDescription& robot_;
  const Parameters& p_;
  const Input& in_;
  State& s_;
  Output& out_;
};

}  // namespace markservo::task_manager
