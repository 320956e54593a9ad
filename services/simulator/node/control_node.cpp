#include "services/simulator/node/control_node.hpp"

#include <exception>
#include <markservo/SimTruth.hpp>

#include "common/logging/log.hpp"
#include "common/messages/motion_messages.hpp"
#include "common/robot/configuration_error.hpp"
#include "services/simulator/messages/truth_messages.hpp"

namespace markservo::simulator {

ControlNode::ControlNode(bus::Bus& bus, Simulation& simulation, RunState& run)
    : simulation_(&simulation), run_(&run), truths_(bus.advertise(channels::kSimTruth)) {}

void ControlNode::on_control(const SimControl& message) {
  const motion::CommandStamp stamp{message.session, message.control_id, message.utime};
  const motion::CommandHeard heard = inbox_.hear(stamp, simulation_->utime(), false);
  if (heard == motion::CommandHeard::kStale) messages::drop(inbox_.why_stale(stamp, simulation_->utime()));
  if (heard == motion::CommandHeard::kExecute) {
    error_.clear();
    try {
      execute(message);
    } catch (const std::exception& error) {
      // Whatever it was: the sender waits for an echo, and silence about a failure would read as done.
      error_ = error.what();
      logging::warn("SIM_CONTROL {}: {}", message.control_id, error_);
    }
  }
  // A reset's echo comes with its first frame; everything else is echoed at once.
  if (!run_->world_is_new && truth_.frame_seq > 0) publish();
}

void ControlNode::execute(const SimControl& message) {
  Assignments changes;
  for (const SimParameter& parameter : message.parameters) changes.emplace_back(parameter.name, parameter.value);
  if (message.kind == SimControl::SET) {
    simulation_->set(changes);
    return;
  }
  if (message.seed < 0) throw ConfigurationError("seed is " + std::to_string(message.seed) + "; allowed: 0 or more");
  simulation_->reset(static_cast<std::uint64_t>(message.seed), changes);
  run_->begin_anew(true);
}

void ControlNode::tell_truth(std::int64_t frame_session, std::int64_t frame_seq) {
  truth_ = truth_message(simulation_->world().truth());
  truth_.utime = truth_.frame_utime = simulation_->utime();
  truth_.frame_session = frame_session;
  truth_.frame_seq = frame_seq;
  publish();
}

void ControlNode::publish() {
  truth_.control_session = inbox_.session();
  truth_.control_id = inbox_.id();
  truth_.control_error = error_;
  truth_.valid = run_->valid ? 1 : 0;
  truths_.publish(truth_);
}

}  // namespace markservo::simulator
