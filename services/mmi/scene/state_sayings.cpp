#include "services/mmi/scene/state_sayings.hpp"

#include <fmt/core.h>

#include <cstddef>
#include <markservo/channels.hpp>
#include <vector>

#include "common/bus/health.hpp"
#include "services/mmi/scene/reason_words.hpp"
#include "services/mmi/scene/state_names.hpp"

namespace markservo::mmi {
namespace {

// The constant's name of a state of the message type.
template <class State>
std::string state_name(const char* type, State state) {
  return state_names(type, "state").at(static_cast<std::size_t>(state));
}

std::string because(const std::string& reason) {
  return reason.empty() ? "" : ": " + reason;
}

Level level_of(TaskPhase phase) {
  switch (phase) {
    case TaskPhase::kHoldLifted:
    case TaskPhase::kDone:
      return Level::kGood;
    case TaskPhase::kStopped:
      return Level::kWarning;
    case TaskPhase::kRefused:
    case TaskPhase::kFailed:
      return Level::kBad;
    default:
      return Level::kInfo;
  }
}

Level level_of(ServoState state) {
  switch (state) {
    case ServoState::kConverged:
      return Level::kGood;
    case ServoState::kLost:
    case ServoState::kStale:
    case ServoState::kStopped:
      return Level::kWarning;
    case ServoState::kUnreachable:
      return Level::kBad;
    default:
      return Level::kInfo;
  }
}

Level level_of(BaseState state) {
  switch (state) {
    case BaseState::kArrived:
      return Level::kGood;
    case BaseState::kBlocked:
    case BaseState::kLost:
    case BaseState::kStale:
    case BaseState::kStopped:
      return Level::kWarning;
    default:
      return Level::kInfo;
  }
}

Level level_of(LocalisationState state) {
  switch (state) {
    case LocalisationState::kLocalised:
      return Level::kGood;
    case LocalisationState::kLost:
      return Level::kBad;
    default:
      return Level::kInfo;
  }
}

Level level_of(ProcessState state) {
  switch (state) {
    case ProcessState::kRunning:
      return Level::kGood;
    case ProcessState::kEnded:
      return Level::kWarning;
    case ProcessState::kSilent:
    case ProcessState::kWaiting:
    case ProcessState::kFailed:
      return Level::kBad;
    default:
      return Level::kInfo;
  }
}

Level level_of(const RecorderReport& recorder) {
  if (recorder.recording) return recorder.why.empty() ? Level::kGood : Level::kWarning;
  return recorder.why.empty() ? Level::kInfo : Level::kBad;
}

// A service's reason may also tell what it does.
bool cannot_work(const ServiceReport& service) {
  return service.state == bus::kWaiting || service.state == bus::kStale;
}

struct SayingOf {
  std::optional<Saying> operator()(const TaskReport& task) const {
    std::string detail;
    if (task.phase == TaskPhase::kLook || task.phase == TaskPhase::kDrive) detail = " " + task.target;
    if (task.attempt > 1) detail += fmt::format(", attempt {}", task.attempt);
    return Saying{ChangeKind::kTask,
                  channels::kTaskState.name,
                  "",
                  task.session,
                  "",
                  state_name("TaskState", task.phase),
                  detail + because(task.reason),
                  fmt::format("{}|{}|{}", task.attempt, task.target, reason_words(task.reason)),
                  level_of(task.phase)};
  }

  std::optional<Saying> operator()(const ServoReport& servo) const {
    return Saying{ChangeKind::kServo,
                  channels::kServoStatus.name,
                  "",
                  servo.session,
                  "arm",
                  state_name("ServoStatus", servo.state),
                  (servo.settled ? ", settled" : "") + because(servo.reason),
                  fmt::format("{}|{}", servo.settled, reason_words(servo.reason)),
                  level_of(servo.state)};
  }

  std::optional<Saying> operator()(const BaseReport& base) const {
    return Saying{ChangeKind::kBase,
                  channels::kBaseStatus.name,
                  "",
                  base.session,
                  "base",
                  state_name("BaseStatus", base.state),
                  because(base.reason),
                  reason_words(base.reason),
                  level_of(base.state)};
  }

  std::optional<Saying> operator()(const PoseReport& pose) const {
    return Saying{ChangeKind::kPose,
                  channels::kRobotPose.name,
                  "",
                  pose.session,
                  "pose",
                  state_name("RobotPose", pose.state),
                  because(pose.reason),
                  "",
                  level_of(pose.state)};
  }

  std::optional<Saying> operator()(const StopReport& stop) const {
    return Saying{ChangeKind::kStop,
                  channels::kStopState.name,
                  stop.device,
                  stop.session,
                  "stop of " + stop.device,
                  stop.latched ? "latched" : "free",
                  because(stop.reason),
                  fmt::format("{}|{}", stop.request_session, stop.request_id),
                  stop.latched ? Level::kWarning : Level::kGood};
  }

  std::optional<Saying> operator()(const ServiceReport& service) const {
    const std::string key = service.name + "@" + service.host;
    return Saying{ChangeKind::kService,
                  channels::kServiceStatus.name,
                  key,
                  service.session,
                  key,
                  service.state,
                  because(service.reason),
                  reason_words(service.reason),
                  cannot_work(service) ? Level::kWarning : Level::kInfo};
  }

  std::optional<Saying> operator()(const ProcessReport& process) const {
    const std::string key = process.name + "@" + process.host;
    return Saying{ChangeKind::kProcess,
                  channels::kProcessStatus.name,
                  key,
                  process.session,
                  "process " + key,
                  state_name("ProcessStatus", process.state),
                  because(process.why),
                  fmt::format("{}|{}", process.restarts, reason_words(process.why)),
                  level_of(process.state)};
  }

  std::optional<Saying> operator()(const RecorderReport& recorder) const {
    const std::string parts = recorder.parts > 1 ? fmt::format(", part {}", recorder.parts) : "";
    return Saying{ChangeKind::kRecording,
                  channels::kRecorderStatus.name,
                  recorder.host + ":" + recorder.folder,
                  recorder.session,
                  recorder.folder,
                  recorder.recording ? "recording" : "ended",
                  parts + because(recorder.why),
                  fmt::format("{}|{}", recorder.parts, reason_words(recorder.why)),
                  level_of(recorder)};
  }

  template <class Other>
  std::optional<Saying> operator()(const Other& /*of no state*/) const {
    return std::nullopt;
  }
};

struct RequestOf {
  std::optional<Request> operator()(const StopRequestReport& stop) const {
    const char* state = stop.reset ? "RESET" : "STOP";
    return Request{
        channels::kStop.name,
        stop.session,
        stop.request_id,
        state,
        fmt::format("{} by {}{}", state, stop.source.empty() ? "somebody" : stop.source, because(stop.reason)),
        stop.reset ? Level::kInfo : Level::kWarning};
  }

  std::optional<Request> operator()(const CommandReport& command) const {
    const std::string state = state_names("TaskCommand", "kind").at(static_cast<std::size_t>(command.kind));
    std::string text = state;
    if (command.kind == CommandKind::kStart) {
      text += " " + command.target;
      if (command.drive) text += ", drive there";
      if (command.carry) text += ", carry it";
    }
    const bool aborts = command.kind == CommandKind::kAbort;
    return Request{channels::kTaskCommand.name,
                   command.session,
                   command.command_id,
                   state,
                   std::move(text),
                   aborts ? Level::kWarning : Level::kInfo};
  }

  template <class Other>
  std::optional<Request> operator()(const Other& /*no request*/) const {
    return std::nullopt;
  }
};

}  // namespace

std::optional<Saying> saying_of(const Report& report) {
  return std::visit(SayingOf{}, report);
}

std::optional<Request> request_of(const Report& report) {
  return std::visit(RequestOf{}, report);
}

}  // namespace markservo::mmi
