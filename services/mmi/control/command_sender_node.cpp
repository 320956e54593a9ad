#include "services/mmi/control/command_sender_node.hpp"

#include "common/messages/motion_messages.hpp"
#include "common/messages/operator_messages.hpp"
#include "common/motion/mover_watch.hpp"
#include "common/time/clocks.hpp"

namespace markservo::mmi {

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
  if (heard == motion::StreamHeard::kSecond) desk_.observe_conflict(task_.words(), steady_seconds());
  messages::drop(motion::why_dropped(heard));
  sender_.observe_task_state(state.utime);
  const std::int64_t ours = state.command_session == bus_->session() ? state.command_id : 0;
  desk_.observe(messages::task_report(state, false), ours, steady_seconds());
}

void CommandSenderNode::tick() {
  for (const CommandToSend& to_send : desk_.step(steady_seconds())) send(to_send);
}

void CommandSenderNode::send(const CommandToSend& to_send) {
  const Command& wish = to_send.command;
  const auto utime = sender_.stamp(messages::command_kind(wish.action));
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
  command.kind = messages::task_command_kind(wish.action);
  command.target = wish.target;
  command.carry = wish.carry ? 1 : 0;
  command.drive_pose = {wish.place.x, wish.place.y, wish.place.heading};
  commands_->publish(command);
}

}  // namespace markservo::mmi
