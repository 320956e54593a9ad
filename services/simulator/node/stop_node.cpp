#include "services/simulator/node/stop_node.hpp"

#include <markservo/StopRequest.hpp>
#include <markservo/StopState.hpp>
#include <string>

#include "common/logging/log.hpp"
#include "common/messages/motion_messages.hpp"

namespace markservo::simulator {

StopNode::StopNode(bus::Bus& bus, Simulation& simulation, const RunState& run)
    : simulation_(&simulation), run_(&run), states_(bus.advertise(channels::kStopState)) {}

void StopNode::on_stop(const StopRequest& message) {
  if (message.kind != StopRequest::STOP && message.kind != StopRequest::RESET) {
    messages::drop("kind is " + std::to_string(message.kind) + "; allowed: 0 (stop) or 1 (reset)");
  }
  motion::StopRequestStamp request{{message.session, message.request_id, message.utime},
                                   message.kind == StopRequest::RESET,
                                   (message.source.empty() ? "someone" : message.source) + ": " + message.reason};
  const motion::StopHeard heard = simulation_->hear_stop(request);
  if (heard == motion::StopHeard::kStale) messages::drop("RESET refused: " + simulation_->why_stale(request));
  if (heard != motion::StopHeard::kAgain) {
    logging::info("STOP {}: {}", simulation_->latch().latched() ? "latched" : "reset", simulation_->latch().reason());
  }
  publish();
}

void StopNode::publish() {
  if (is_ahead()) return;
  StopState message{};
  message.utime = simulation_->utime();
  const motion::StopLatch& latch = simulation_->latch();
  message.latched = latch.latched() ? 1 : 0;
  message.request_session = latch.session();
  message.request_id = latch.id();
  message.reason = latch.reason();
  message.device = "arm";
  states_.publish(message);
  if (simulation_->has_base()) {
    message.device = "base";
    states_.publish(message);
  }
  timer_.restart(message.utime);
  told_latched_ = latch.latched();
}

void StopNode::repeat() {
  if (timer_.due(simulation_->utime())) publish();
}

void StopNode::tell_of_a_latch() {
  if (simulation_->latch().latched() == told_latched_ || is_ahead()) return;
  logging::warn("STOP latched: {}", simulation_->latch().reason());
  publish();
}

}  // namespace markservo::simulator
