// I1 to I3: what may move, and when.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <initializer_list>
#include <map>
#include <optional>
#include <utility>

#include "common/time/seconds_between.hpp"
#include "tests/system/fault_campaign/floor.hpp"
#include "tests/system/fault_campaign/invariants.hpp"
#include "tests/system/fault_campaign/motion.hpp"
#include "tests/system/fault_campaign/mover.hpp"
#include "tests/system/fault_campaign/words.hpp"

namespace markservo::campaign {
namespace {

// While a device of one simulator is latched, by its own word.
struct Latch {
  std::int64_t session = 0;
  std::int64_t t = 0;
  double from = 0.0;  // s, world
  double to = 0.0;
};

std::vector<Latch> latches(const Timeline& timeline, const std::string& device) {
  std::vector<Latch> found;
  std::optional<Latch> open;
  const auto close = [&](double world) {
    if (!open) return;
    open->to = world;
    found.push_back(*open);
    open.reset();
  };
  double last = 0.0;
  for (const auto& heard : timeline.stop_states) {
    const StopState& state = heard.message;
    if (heard.foreign || state.device != device || !timeline.is("simulator", state.session)) continue;
    if (open && open->session != state.session) close(last);
    if (state.latched && !open) open = Latch{state.session, heard.t, heard.world, 0.0};
    // It may have been released any time since it last said that it was not.
    if (!state.latched) close(last);
    last = heard.world;
  }
  close(timeline.clock.at(timeline.ended_at));
  return found;
}

void judge_arm_latches(const Timeline& timeline, const Bars& bars, Verdict& verdict) {
  for (const Latch& latch : latches(timeline, "arm")) {
    const double from = latch.from + bars.latch_time + bars.arm_braking;
    const Heard<SimTruth>* rest = nullptr;
    const Heard<SimTruth>* last = nullptr;
    for (const auto& truth : timeline.truth) {
      if (truth.message.session != latch.session || truth.world < from || truth.world > latch.to) continue;
      if (last == nullptr || !same_world(last->message, truth.message)) {
        rest = &truth;
        ++verdict.judged;
      }
      last = &truth;
      const double way = farthest_joint(rest->message.shaft, truth.message.shaft);
      if (way > bars.arm_still_rad) {
        note(verdict, truth.t,
             text("latched since %.2f s (world), and the arm moved %.4f rad by %.2f s", latch.from, way, truth.world));
        break;
      }
    }
  }
}

void judge_base_latches(const Timeline& timeline, const Bars& bars, Verdict& verdict) {
  for (const Latch& latch : latches(timeline, "base")) {
    const Heard<SimBaseTruth>* rest = nullptr;
    double from = latch.from + bars.latch_time;
    bool braking_known = false;
    for (const auto& truth : timeline.base_truth) {
      if (truth.message.session != latch.session || truth.world < latch.from || truth.world > latch.to) continue;
      if (!braking_known) from += base_braking(truth.message, bars);
      braking_known = true;
      if (truth.world < from) continue;
      if (rest == nullptr) {
        rest = &truth;
        ++verdict.judged;
      }
      const std::string moved = base_moved(rest->message, truth.message, bars.base_still_m, bars.base_still_rad);
      if (!moved.empty()) {
        note(verdict, truth.t,
             text("latched since %.2f s (world), and the base %s by %.2f s", latch.from, moved.c_str(), truth.world));
        break;
      }
    }
  }
}

// STOPs that a mover must obey: well-formed, and asked for the first time. A STOP is obeyed whatever its time and text.
std::vector<const Heard<StopRequest>*> new_stops(const Timeline& timeline) {
  std::vector<const Heard<StopRequest>*> stops;
  std::map<std::int64_t, std::int64_t> last_id;  // by session
  for (const auto& heard : timeline.stops) {
    const StopRequest& asked = heard.message;
    if (asked.session <= 0 || asked.request_id <= 0 || asked.utime <= 0) continue;
    std::int64_t& last = last_id[asked.session];
    const bool fresh = asked.request_id > last;
    last = std::max(last, asked.request_id);
    if (fresh && asked.kind == StopRequest::STOP) stops.push_back(&heard);
  }
  return stops;
}

// By the mover's word: latched once it has lived for a moment after a STOP. Its own life is counted, for a machine may
// be slow, and a process may hang.
void judge_stop_is_obeyed(const Timeline& timeline, const std::string& device, const Bars& bars, Verdict& verdict) {
  constexpr double kStep_s = 0.05;  // more between two stamps: it did not live then
  for (const Heard<StopRequest>* stop : new_stops(timeline)) {
    if (timeline.loses_messages(stop->t) || timeline.flooded(stop->t)) continue;
    std::int64_t mover = 0;
    for (const auto& heard : timeline.stop_states) {
      const bool own = !heard.foreign && timeline.is("simulator", heard.message.session);
      if (own && heard.message.device == device && heard.t <= stop->t) mover = heard.message.session;
    }
    double lived = 0.0;
    std::int64_t due = 0;  // us, when it has lived so long
    std::int64_t before = 0;
    for (const auto& truth : timeline.base_truth) {
      if (truth.message.session != mover || truth.t < stop->t) continue;
      if (before != 0) lived += std::clamp(seconds_between(before, truth.message.utime), 0.0, kStep_s);
      before = truth.message.utime;
      if (lived <= bars.latch_time + bars.hearing) continue;
      due = truth.t;
      break;
    }
    if (mover == 0 || due == 0) continue;
    ++verdict.judged;
    const bool latched = std::any_of(timeline.stop_states.begin(), timeline.stop_states.end(), [&](const auto& heard) {
      return !heard.foreign && heard.message.session == mover && heard.message.device == device &&
             heard.message.latched && heard.t >= stop->t && heard.t <= due;
    });
    if (latched || timeline.loses_messages(due)) continue;
    note(verdict, due,
         text("STOP was asked at %.2f s (world), and the %s has not said within %.2f s that it is latched", stop->world,
              device.c_str(), lived));
  }
}

// The newest legal goal to move that was heard before the world's `end`; s, world; -1 when there was none.
template <class M>
double newest_goal(const std::vector<const Heard<M>*>& goals, double end) {
  double newest = -1.0;
  for (const Heard<M>* goal : goals) {
    if (goal->world > end) break;
    newest = goal->world;
  }
  return newest;
}

// Until when a motion may go on: a goal is obeyed while it is young enough, its last command a little longer, and then
// there is the braking, from the speed at which the arm or the base truly moved then.
class MotionByGoal {
 public:
  explicit MotionByGoal(const Bars& bars) : age_(bars.goal_age + bars.command_age) {}

  // Whether the step from `from` to `to` (s, world) may be. To be asked of each step. `goal`: s, world, the newest
  // one's; below 0: none. `braking`: s, from this step's speed.
  bool may(double goal, double from, double to, double braking) {
    const double expired = goal + age_;
    if (goal != braked_for_ && to >= expired) {
      braked_for_ = goal;
      braked_ = expired + braking;
    }
    return goal >= 0.0 && (from <= expired || (braked_for_ == goal && from <= braked_));
  }

 private:
  double age_;
  double braked_ = 0.0;       // s, world: when it stands
  double braked_for_ = -2.0;  // after that goal
};

void judge_arm_motion(const Timeline& timeline, const Bars& bars, Verdict& verdict) {
  const auto offered = offered_to_arm(timeline, bars);
  const Commands commands = judged_as_the_mover(timeline, offered, "arm", bars);
  const auto goals = legal_goals(timeline, timeline.servo_goals, ServoGoal::HOLD, bars.goal_age);
  MotionByGoal motion(bars);
  for (const ArmStep& step : arm_steps(timeline)) {
    const double goal = newest_goal(goals, step.to->world);
    const double braking = bars.arm_settles + step.speed / bars.arm_deceleration;
    const bool may = motion.may(goal, step.from->world, step.to->world, braking);
    if (step.speed <= bars.arm_moves_rad_s) continue;
    ++verdict.judged;
    if (may) continue;
    if (moved_by_a_stranger(commands, step.from->world, step.to->world, bars.command_age + bars.arm_braking, bars))
      continue;
    note(verdict, step.to->t,
         text("the arm moves at %.3f rad/s at %.2f s (world); the newest legal SERVO_GOAL to move: %s", step.speed,
              step.to->world, goal < 0.0 ? "none" : text("%.2f s", goal).c_str()));
  }
}

void judge_base_motion(const Timeline& timeline, const Bars& bars, Verdict& verdict) {
  const auto offered = offered_to_base(timeline, bars);
  const Commands commands = judged_as_the_mover(timeline, offered, "base", bars);
  const auto goals = legal_goals(timeline, timeline.base_goals, BaseGoal::HOLD, bars.goal_age);
  MotionByGoal motion(bars);
  for (const BaseStep& step : base_steps(timeline)) {
    const double goal = newest_goal(goals, step.to->world);
    const double braking = base_braking(step.to->message, bars);
    const bool may = motion.may(goal, step.from->world, step.to->world, braking);
    if (step.speed <= bars.base_moves_m_s && step.turn_rate <= bars.base_turns_rad_s) continue;
    ++verdict.judged;
    if (may) continue;
    const double moment = bars.command_age + braking;
    if (moved_by_a_stranger(commands, step.from->world, step.to->world, moment, bars)) continue;
    note(verdict, step.to->t,
         text("the base moves at %.3f m/s and %.3f rad/s at %.2f s (world); the newest legal BASE_GOAL to move: %s",
              step.speed, step.turn_rate, step.to->world, goal < 0.0 ? "none" : text("%.2f s", goal).c_str()));
  }
}

// What a mover says that it follows: the one who has the floor, or had it a moment ago.
template <class Status, class Goal>
void judge_followed(const Timeline& timeline, const Stream<Status>& statuses, const Stream<Goal>& goals,
                    const char* channel, const char* service, std::initializer_list<int> moving, const Bars& bars,
                    Verdict& verdict) {
  if (goals.empty() && timeline.traffic.count(channel) > 0) return;  // of another version of the type
  const auto holders = floor_holders(timeline, goals, bars.goal_age);
  const double moment = 2.0 * bars.goal_age + bars.command_age;
  for (const auto& heard : statuses) {
    const Status& status = heard.message;
    if (heard.foreign || !timeline.is(service, status.session) || status.goal_session == 0) continue;
    if (std::find(moving.begin(), moving.end(), status.state) == moving.end()) continue;
    ++verdict.judged;
    if (had_the_floor(holders, status.goal_session, heard.world - moment, heard.world + bars.hearing)) continue;
    if (timeline.loses_messages(heard.t)) continue;
    note(verdict, heard.t,
         text("%s follows a goal of session %ld at %.2f s (world), which does not have the floor", service,
              static_cast<long>(status.goal_session), heard.world));
  }
}

// A goal is legal only where the task behind it is: the stack obeys no START or HOME of another time.
void judge_tasks(const Timeline& timeline, const Bars& bars, Verdict& verdict) {
  std::pair<std::int64_t, std::int64_t> obeyed{0, 0};
  for (const auto& heard : timeline.task_states) {
    const TaskState& task = heard.message;
    if (heard.foreign || !timeline.is("task-manager", task.session)) continue;
    const std::pair<std::int64_t, std::int64_t> told{task.command_session, task.command_id};
    // What is refused is told too, and an ABORT, which is obeyed whatever its text: of a long one the start alone is
    // kept.
    const bool begun = task.state != TaskState::REFUSED && task.state != TaskState::IDLE &&
                       task.state != TaskState::STOPPED && task.state != TaskState::FAILED;
    if (told == obeyed || !begun) continue;
    obeyed = told;
    double age = -1.0;  // s, the least; below 0: not heard
    bool aborted = false;
    for (const auto& command : timeline.task_commands) {
      const TaskCommand& asked = command.message;
      const bool same = asked.session == told.first && asked.command_id == told.second;
      if (!same || command.t > heard.t) continue;
      aborted = aborted || asked.kind == TaskCommand::ABORT;
      if (asked.kind == TaskCommand::ABORT) continue;
      const double apart = std::abs(seconds_between(asked.utime, task.utime));
      age = age < 0.0 ? apart : std::min(age, apart);
    }
    if (age < 0.0 && (aborted || timeline.loses_messages(heard.t) || timeline.flooded(heard.t))) continue;
    ++verdict.judged;
    if (age >= 0.0 && age <= bars.reset_age + bars.task_slack) continue;
    note(verdict, heard.t,
         age < 0.0 ? text("a task was begun at %.2f s (world) by a TASK_COMMAND that nobody gave", heard.world)
                   : text("a task was begun at %.2f s (world) by a TASK_COMMAND %.1f s from then", heard.world, age));
  }
}

}  // namespace

Verdict latched_is_still(const Timeline& timeline, const Bars& bars) {
  Verdict verdict;
  judge_arm_latches(timeline, bars, verdict);
  judge_base_latches(timeline, bars, verdict);
  judge_stop_is_obeyed(timeline, "arm", bars, verdict);
  judge_stop_is_obeyed(timeline, "base", bars, verdict);
  return verdict;
}

Verdict motion_has_a_goal(const Timeline& timeline, const Bars& bars) {
  Verdict verdict;
  judge_tasks(timeline, bars, verdict);
  judge_followed(timeline, timeline.servo_statuses, timeline.servo_goals, "SERVO_GOAL", "visual-servo",
                 {ServoStatus::POSTURE, ServoStatus::SERVO}, bars, verdict);
  judge_followed(timeline, timeline.base_statuses, timeline.base_goals, "BASE_GOAL", "base-navigator",
                 {BaseStatus::DRIVING}, bars, verdict);
  judge_arm_motion(timeline, bars, verdict);
  judge_base_motion(timeline, bars, verdict);
  return verdict;
}

}  // namespace markservo::campaign
