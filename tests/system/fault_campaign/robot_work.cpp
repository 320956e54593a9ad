#include "tests/system/fault_campaign/robot_work.hpp"

#include <algorithm>
#include <cmath>
#include <markservo/StopRequest.hpp>
#include <markservo/TaskCommand.hpp>

#include "common/bus/session.hpp"
#include "common/time/seconds_between.hpp"
#include "tests/experiments/task_words.hpp"
#include "tests/system/fault_campaign/bars.hpp"
#include "tests/system/fault_campaign/message_craft.hpp"

namespace markservo::campaign {
namespace {

constexpr double kRepeat_s = 0.3;
constexpr double kPatience_s = 40.0;      // a slow machine needs 20 for the carry
constexpr double kIdle_s = 1.5;           // released and doing nothing
constexpr double kDriving = 0.1;          // m/s
const double kMoves = Bars().task_moves;  // rad, m
constexpr std::size_t kStopDevices = 2;   // arm and base

bool is_end(int state) {
  return state == TaskState::DONE || state == TaskState::HOLD_LIFTED || state == TaskState::REFUSED ||
         state == TaskState::FAILED || state == TaskState::STOPPED || state == TaskState::IDLE;
}

}  // namespace

RobotWork::RobotWork(Bench& bench) : bench_(bench), session_(bus::random_session()) {}

std::string RobotWork::simulator_arguments(const std::string& phase) {
  // 1 m before the dock of config/scenes/shelf.yaml.
  return phase == "drive" ? " --set base.start_y=0.05" : "";
}

bool RobotWork::fail(const std::string& problem) {
  problem_ = problem;
  return false;
}

bool RobotWork::release() {
  if (!bench_.listen(kPatience_s, [&] { return bench_.stop_states().size() >= kStopDevices; })) {
    return fail("the stop devices were not heard");
  }
  StopRequest request{};
  request.kind = StopRequest::RESET;
  request.session = session_;
  request.request_id = next_id_++;
  request.source = "campaign";
  request.reason = "a trial begins";
  const auto released = [&](const auto& heard) {
    const StopState& state = heard.second;
    return !state.latched && state.request_session == request.session && state.request_id == request.request_id;
  };
  const auto all_released = [&] {
    const auto& heard = bench_.stop_states();
    return std::all_of(heard.begin(), heard.end(), released);
  };
  for (double waited = 0.0; waited < kPatience_s; waited += kRepeat_s) {
    request.utime = 0;
    for (const auto& [device, state] : bench_.stop_states()) request.utime = std::max(request.utime, state.utime);
    bench_.send("STOP", encoded(request));
    if (bench_.listen(kRepeat_s, all_released)) return true;
  }
  return fail("the reset was not obeyed");
}

bool RobotWork::start(bool drive, bool carry) {
  if (!bench_.listen(kPatience_s, [&] { return bench_.task().utime > 0; })) return fail("no TASK_STATE was heard");
  TaskCommand command{};
  command.kind = TaskCommand::START;
  command.session = session_;
  command.command_id = next_id_++;
  command.target = kTarget;
  command.carry = carry ? 1 : 0;
  command.drive = drive ? 1 : 0;
  if (drive) command.drive_pose = Pose2{0.20, 1.05, std::acos(0.0)};
  bench_.fact({{"kind", "start"}, {"target", command.target}});
  const auto echoed = [&] {
    return bench_.task().command_session == command.session && bench_.task().command_id == command.command_id;
  };
  for (double waited = 0.0; waited < kPatience_s; waited += kRepeat_s) {
    command.utime = bench_.task().utime;
    bench_.send("TASK_COMMAND", encoded(command));
    if (bench_.listen(kRepeat_s, echoed)) {
      started_ = true;
      return true;
    }
  }
  return fail("START was not answered");
}

bool RobotWork::in_phase(const std::string& phase) const {
  const int state = bench_.task().state;
  if (phase == "drive") return state == TaskState::DRIVE && std::abs(bench_.base_truth().speed) > kDriving;
  if (phase == "approach") return state == TaskState::APPROACH;
  if (phase == "servo") return state == TaskState::SERVO;
  if (phase == "grip") return state == TaskState::GRIP;
  if (phase == "lifted") return state == TaskState::HOLD_LIFTED;
  return phase == "carry" && state == TaskState::CARRY;
}

bool RobotWork::bring_to(const std::string& phase) {
  if (!release()) return false;
  if (phase == "idle") {
    bench_.listen(kIdle_s);
    bench_.fact({{"kind", "phase"}, {"phase", phase}});
    return true;
  }
  if (!start(phase == "drive", phase == "carry")) return false;
  bool over = false;
  bench_.listen(kPatience_s, [&] {
    over = is_end(bench_.task().state);
    return in_phase(phase) || over;
  });
  if (!in_phase(phase)) {
    return fail("the task is in " + std::string(experiments::task_state_name(bench_.task().state)) + " (" +
                bench_.task().reason + ") instead of " + phase);
  }
  bench_.fact({{"kind", "phase"}, {"phase", phase}});
  return true;
}

void RobotWork::watch_for_standstill() {
  seen_arm_ = bench_.truth();
  seen_base_ = bench_.base_truth();
  seen_state_ = bench_.task().state;
}

double RobotWork::stands_for() {
  const SimTruth& arm = bench_.truth();
  const SimBaseTruth& base = bench_.base_truth();
  bool same = seen_state_ == bench_.task().state && base.session == seen_base_.session &&
              base.utime >= seen_base_.utime && arm.shaft.size() == seen_arm_.shaft.size();
  for (std::size_t i = 0; same && i < arm.shaft.size(); ++i) {
    same = std::abs(arm.shaft[i] - seen_arm_.shaft[i]) <= kMoves;
  }
  same = same && std::hypot(base.pose.x - seen_base_.pose.x, base.pose.y - seen_base_.pose.y) <= kMoves &&
         std::abs(base.pose.heading - seen_base_.pose.heading) <= kMoves;
  if (!same) watch_for_standstill();
  return seconds_between(seen_base_.utime, base.utime);
}

double RobotWork::world_seconds() {
  clock_.heard(Bench::now(), bench_.base_truth().utime);
  return clock_.at(Bench::now());
}

bool RobotWork::task_ended() const {
  return !started_ || is_end(bench_.task().state);
}

}  // namespace markservo::campaign
