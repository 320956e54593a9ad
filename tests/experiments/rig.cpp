#include "tests/experiments/rig.hpp"

#include <algorithm>
#include <markservo/ServiceStatus.hpp>

#include "common/bus/repeat_timer.hpp"

namespace markservo::experiments {
namespace {

constexpr std::chrono::seconds kPatience{60};
constexpr std::chrono::milliseconds kNudge{300};

bus::BusParameters parameters(const std::string& lcm_url, const std::string& robot) {
  bus::BusParameters result;
  result.urls = {lcm_url, lcm_url};
  result.service_name = "experiment";
  result.robot = robot;
  return result;
}

}  // namespace

Rig::Rig(const std::string& lcm_url, const std::string& robot, Pace pace)
    : pace_(pace),
      bus_(parameters(lcm_url, robot)),
      controls_(bus_.advertise(channels::kSimControl)),
      stops_(bus_.advertise(channels::kStop)),
      commands_(bus_.advertise(channels::kTaskCommand)),
      goals_(bus_.advertise(channels::kServoGoal)) {
  bus_.on_each(channels::kSimTruth, [this](const SimTruth& truth) { truth_ = truth; });
  bus_.on_each(channels::kServoStatus, [this](const ServoStatus& status) { servo_ = status; });
  bus_.on_each(channels::kTaskState, [this](const TaskState& state) { task_ = state; });
  bus_.on_latest(channels::kMarkDetection, [this](const MarkDetection& detection) { detection_ = detection; });
  bus_.on_each(channels::kStopState, [this](const StopState& state) {
    stops_heard_[state.device] = state;
    sender_.observe_stop_state(state.device, state.utime);
  });
  bus_.on_each(channels::kServiceStatus, [this](const ServiceStatus& status) {
    if (status.state != "starting") started_.insert(status.pid);
  });
}

void Rig::wait(const char* what, const std::function<bool()>& done, const std::function<void()>& nudge) {
  const auto begin = std::chrono::steady_clock::now();
  auto nudged = begin;
  while (!done()) {
    if (!bus_.poll(std::chrono::milliseconds(50))) throw RigFailure("interrupted");
    const auto now = std::chrono::steady_clock::now();
    if (now - begin > kPatience) throw RigFailure(std::string("no answer within 60 s: ") + what);
    if (nudge && now - nudged > kNudge) {
      nudge();
      nudged = now;
    }
  }
}

void Rig::wait_for_service(const std::string& name, pid_t pid) {
  wait((name + " to say that it is ready").c_str(), [&] { return started_.count(pid) > 0; });
}

void Rig::wait_for_world() {
  wait("the simulator's first SIM_TRUTH", [this] { return truth_.frame_seq > 0; });
}

void Rig::reset(std::int64_t seed, const Settings& settings) {
  SimControl control{};
  control.kind = SimControl::RESET;
  control.session = controls_.session();
  control.control_id = next_id_++;
  control.seed = seed;
  for (const auto& [name, value] : settings) {
    control.parameters.emplace_back();
    control.parameters.back().name = name;
    control.parameters.back().value = value;
  }
  control.num_parameters = static_cast<std::int32_t>(control.parameters.size());
  const auto send = [&] {
    control.utime = truth_.utime;  // anew each time: an old one is refused
    controls_.publish(control);
    send_step();
  };
  goal_ = ServoGoal{};
  send();
  wait(
      "SIM_CONTROL RESET",
      [&] { return truth_.control_session == control.session && truth_.control_id == control.control_id; }, send);
  if (!truth_.control_error.empty()) throw RigFailure("the simulator refuses: " + truth_.control_error);
}

void Rig::unlatch(const std::function<bool()>& answered) {
  if (answered && pace_ == Pace::kLockstep) wait("the services' answer to the first frame", answered);
  StopRequest request{};
  request.kind = StopRequest::RESET;
  request.session = stops_.session();
  request.request_id = next_id_++;
  request.source = "experiment";
  request.reason = "a trial begins";
  const auto send = [&] {
    const auto stamp = sender_.stamp(motion::CommandKind::kReset);
    if (!stamp) return;  // a stop device is not heard yet
    request.utime = *stamp;
    stops_.publish(request);
  };
  send();
  const auto released = [&](const auto& heard) {
    const StopState& state = heard.second;
    return !state.latched && state.request_session == request.session && state.request_id == request.request_id;
  };
  wait(
      "STOP reset",
      [&] { return !stops_heard_.empty() && std::all_of(stops_heard_.begin(), stops_heard_.end(), released); }, send);
}

void Rig::send_step() {
  if (pace_ == Pace::kRealTime) return;
  SimControl control{};
  control.kind = SimControl::STEP;
  control.utime = truth_.utime;
  control.session = controls_.session();
  control.frame_session = truth_.frame_session;
  control.frame_seq = truth_.frame_seq;
  controls_.publish(control);
}

void Rig::step(const std::function<bool()>& answered) {
  if (answered && pace_ == Pace::kLockstep) wait("the services' answer to a frame", answered);
  if (goal_.goal_id > 0 && truth_.utime - goal_sent_utime_ >= bus::kStateRepeat_us) {
    goal_.utime = goal_sent_utime_ = truth_.utime;
    goals_.publish(goal_);
  }
  const std::int64_t session = truth_.frame_session;
  const std::int64_t seq = truth_.frame_seq;
  send_step();
  wait(
      "the next frame", [&] { return truth_.frame_session != session || truth_.frame_seq > seq; },
      [this] { send_step(); });
  if (!truth_.valid) throw RigFailure("the run is invalid: a service did not answer a frame in time");
}

void Rig::wait_for_detection() {
  wait(channels::kMarkDetection.name, [this] { return detection_answered(); });
}

void Rig::command(TaskCommand message) {
  message.session = commands_.session();
  message.command_id = next_id_++;
  const auto echoed = [&] {
    return task_.command_session == message.session && task_.command_id == message.command_id;
  };
  const auto begin = std::chrono::steady_clock::now();
  while (!echoed()) {
    if (std::chrono::steady_clock::now() - begin > kPatience) throw RigFailure("no task-manager answers TASK_COMMAND");
    if (pace_ == Pace::kLockstep) wait(channels::kTaskState.name, [this] { return task_answered(); });
    message.utime = truth_.utime;
    commands_.publish(message);
    step();
  }
}

void Rig::give_goal(const ServoGoal& goal) {
  goal_ = goal;
  goal_.goal_id = next_id_++;
  goal_.utime = goal_sent_utime_ = truth_.utime;
  goals_.publish(goal_);
}

}  // namespace markservo::experiments
