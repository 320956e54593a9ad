#include "services/mmi/control/command_sender_node.hpp"

#include "common/messages/motion_messages.hpp"
#include "common/messages/state_codes.hpp"
#include "common/motion/mover_watch.hpp"
#include "common/time/clocks.hpp"

namespace markservo::mmi {
namespace {

motion::CommandKind sending_kind(task::Action action) {
  switch (action) {
    case task::Action::kStart:
      return motion::CommandKind::kStart;
    case task::Action::kHome:
      return motion::CommandKind::kHome;
    case task::Action::kDrive:
      return motion::CommandKind::kDrive;
    case task::Action::kReset:
      return motion::CommandKind::kReset;
    case task::Action::kStop:
      return motion::CommandKind::kStop;
    case task::Action::kAbort:
      break;
  }
  return motion::CommandKind::kAbort;
}

std::int8_t message_kind(task::Action action) {
  switch (action) {
    case task::Action::kStart:
      return TaskCommand::START;
    case task::Action::kHome:
      return TaskCommand::HOME;
    case task::Action::kDrive:
      return TaskCommand::DRIVE;
    default:
      return TaskCommand::ABORT;
  }
}

}  // namespace

void CommandSenderNode::start(bus::Bus& bus) {
  bus_ = &bus;
  stops_.emplace(bus.advertise(channels::kStop));
  commands_.emplace(bus.advertise(channels::kTaskCommand));
  bus.on_each(channels::kTaskState, [this](const TaskState& state) { observe(state); });
}

void CommandSenderNode::observe(const StopState& state) {
  sender_.observe_stop_state(state.device, state.utime);
  const std::int64_t ours = state.request_session == bus_->session() ? state.request_id : 0;
  desk_.observe(task::StopReport{state.device, state.latched != 0, false, state.reason}, ours, state.request_id != 0,
                steady_seconds());
}

void CommandSenderNode::observe(const TaskState& state) {
  const motion::StreamHeard heard = task_.hear(messages::stamp_of(state), 0);
  desk_.observe_conflict(heard == motion::StreamHeard::kSecond ? task_.words() : "");
  messages::drop(motion::why_dropped(heard));
  sender_.observe_task_state(state.utime);
  task::TaskReport report;
  report.time = 1e-6 * static_cast<double>(state.utime);
  if (state.command_session != 0) report.answers = task::Answers::kAnother;
  report.phase = messages::state_of<task::Phase>(state.state);
  report.attempt = state.attempt;
  report.target = state.target;
  report.reason = state.reason;
  const std::int64_t ours = state.command_session == bus_->session() ? state.command_id : 0;
  desk_.observe(report, ours, steady_seconds());
}

void CommandSenderNode::tick() {
  for (const CommandToSend& to_send : desk_.step(steady_seconds())) send(to_send);
}

void CommandSenderNode::send(const CommandToSend& to_send) {
  const Command& wish = to_send.command;
  const auto utime = sender_.stamp(sending_kind(wish.action));
  if (!utime) return;  // it would be refused; who has not spoken is told when patience ends
  if (wish.action == task::Action::kReset) {
    StopRequest request{};
    request.utime = *utime;
    request.session = bus_->session();
    request.request_id = to_send.id;
    request.kind = StopRequest::RESET;
    request.source = "page";
    request.reason = "asked by an operator";
    stops_->publish(request);
    return;
  }
  TaskCommand command{};
  command.utime = *utime;
  command.session = bus_->session();
  command.command_id = to_send.id;
  command.kind = message_kind(wish.action);
  command.target = wish.target;
  command.carry = wish.carry ? 1 : 0;
  command.drive_pose = {wish.place.x, wish.place.y, wish.place.heading};
  commands_->publish(command);
}

}  // namespace markservo::mmi
