#include "services/task-manager/procedure.hpp"

#include <fmt/format.h>

#include <cassert>
#include <cstdint>
#include <utility>

#include "common/task/transitions.hpp"
#include "services/task-manager/commands.hpp"
#include "services/task-manager/phases/endings.hpp"

namespace markservo::task_manager {
namespace {

constexpr std::int64_t kWorthAWord_us = 500'000;

// One step of the procedure, at work.
class Step {
 public:
  Step(const robot::RobotDescription& robot, const Parameters& parameters, const Input& input, State& state,
       Output& output)
      : in_(input), s_(state), out_(output), context_{robot,        parameters,    input,           state.clock,
                                                      state.task,   state.holding, state.arm_goals, state.base_goals,
                                                      state.reason, output.notices} {}

  void run();

 private:
  Phase phase() const { return phase_of(s_.phase); }
  bool waits_for_first_word() const;
  bool base_may_drive() const;

  void enter(Transition transition);
  void watch_the_clock();
  void watch_the_arm();
  void watch_the_stop_devices();
  void watch_the_hand();
  void watch_the_servo();
  void insist_on_rest();
  void command_arm_and_base();
  void tell_state();

  const Input& in_;
  State& s_;
  Output& out_;
  PhaseContext context_;
};

void Step::run() {
  s_.arm_goals.observe(in_.servo.goal_id, in_.utime);
  if (in_.base) s_.base_goals.observe(in_.base->goal_id, in_.utime);
  watch_the_clock();
  watch_the_arm();
  watch_the_stop_devices();
  watch_the_hand();
  for (const Command& command : in_.commands) {
    if (auto next = hear(command, phase(), s_.inbox, context_)) enter(std::move(*next));
  }
  watch_the_servo();
  insist_on_rest();
  if (auto next = step(s_.phase, context_)) enter(std::move(*next));
  command_arm_and_base();
  tell_state();
}

void Step::enter(Transition transition) {
  const Phase left = phase();
  const Phase entered = phase_of(transition.next);
  assert(left == entered || may_follow(left, entered));
  s_.task.result = result_after(left, entered, s_.task.result);
  s_.phase = std::move(transition.next);
  s_.reason = std::move(transition.reason);
  begin(s_.phase, context_);
}

void Step::watch_the_clock() {
  const TaskClock::Tick tick = s_.clock.advance(in_.utime);
  if (tick.set_back) s_.servo = ServoWatch();
  if (!under_way(phase())) return;
  if (tick.set_back) enter(stopped("the clock of SERVO_STATUS was set back"));
  if (tick.passed_over_us < kWorthAWord_us) return;
  out_.notices.push_back(fmt::format("SERVO_STATUS left out {:.1f} s by its times: the task goes on from there",
                                     1e-6 * static_cast<double>(tick.passed_over_us)));
}

void Step::watch_the_arm() {
  if (!s_.arm.restarts(in_.arm)) return;
  if (stop_ends(phase())) {
    enter(stopped("the arm restarted"));
  } else if (!s_.arm_goals.none_yet()) {
    hold_arm(context_);
  }
}

void Step::watch_the_stop_devices() {
  if (const auto ending = s_.stops.observe(in_.stop, phase(), waits_for_first_word())) enter(transition_to(*ending));
  // Without a new goal the gripper would be told nothing.
  if (s_.stops.was_reset() && !s_.arm_goals.none_yet()) hold_arm(context_);
}

void Step::watch_the_hand() {
  if (!s_.holding.loses(in_.arm, under_way(phase()))) return;
  const std::string what = "the hand does not hold " + s_.task.command.target + " any more";
  out_.notices.push_back(what);
  // Nothing is left to be held up: the arm stays where it is now.
  if (phase() == Phase::kHoldLifted) enter(stopped(what));
}

void Step::watch_the_servo() {
  const bool moving = under_way(phase()) && phase() != Phase::kLook;
  const auto ending = s_.servo.observe(in_.servo, moving, s_.arm_goals.newest().id, s_.clock.now(),
                                       context_.parameters.motion.stale_timeout);
  if (ending) enter(transition_to(*ending));
}

// Whoever took the floor before us, an earlier run of ours perhaps, may have fallen silent by now: only a new goal is
// heard then.
void Step::insist_on_rest() {
  const bool resting = !under_way(phase()) && !in_.stop.latched;
  const auto ignored = [](const auto& report, std::int64_t id) {
    return report.goal_id != id && !report.follows_another;
  };
  s_.arm_goals.insist(resting && ignored(in_.servo, s_.arm_goals.newest().id), in_.utime);
  const bool base_rests = resting && !s_.base_goals.newest().drive;
  s_.base_goals.insist(base_rests && in_.base && ignored(*in_.base, s_.base_goals.newest().id), in_.utime);
}

// Nothing has moved for the task yet.
bool Step::waits_for_first_word() const {
  const Drive* drive = std::get_if<Drive>(&s_.phase);
  return (phase() == Phase::kLook && s_.task.attempt == 1) || (drive != nullptr && drive->waits_for_first_word());
}

bool Step::base_may_drive() const {
  const Drive* drive = std::get_if<Drive>(&s_.phase);
  return drive != nullptr && drive->is_driving();
}

// The arm holds before the first task, but not before its device is known: who reports before may be anyone, and the
// hand may hold something. The base stands whenever it is not driving for a task: the arm works, or nothing is known of
// what is around.
void Step::command_arm_and_base() {
  if (s_.arm_goals.none_yet() && in_.arm && in_.stop.known) hold_arm(context_);
  out_.goal = s_.arm_goals.due(in_.utime);
  if (!context_.robot.base) return;
  if (!base_may_drive()) s_.base_goals.hold();
  out_.drive_goal = s_.base_goals.due(in_.utime);
}

void Step::tell_state() {
  out_.phase = phase();
  out_.attempt = s_.task.attempt;
  out_.result = s_.task.result;
  out_.target = s_.task.command.target;
  out_.reason = s_.reason;
  out_.command_session = s_.inbox.session();
  out_.command_id = s_.inbox.id();
}

}  // namespace

Procedure::Procedure(robot::RobotDescription robot, Parameters parameters)
    : robot_(std::move(robot)), parameters_(parameters) {}

Output Procedure::step(const Input& input, State& state) const {
  Output output;
  Step(robot_, parameters_, input, state, output).run();
  return output;
}

}  // namespace markservo::task_manager
