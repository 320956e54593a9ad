#include "services/simulator/node/base_node.hpp"

#include <algorithm>
#include <markservo/BaseStatus.hpp>
#include <markservo/RfidTagHits.hpp>
#include <markservo/RobotPose.hpp>
#include <markservo/SimBaseTruth.hpp>
#include <markservo/SonarScan.hpp>
#include <markservo/WheelOdometry.hpp>

#include "common/messages/motion_messages.hpp"
#include "services/simulator/messages/base_messages.hpp"

namespace markservo::simulator {

BaseNode::BaseNode(bus::Bus& bus, Simulation& simulation, const std::vector<std::string>& awaited)
    : simulation_(&simulation),
      barrier_(awaited),
      rounds_(bus.advertise(channels::kRfidTagHits)),
      scans_(bus.advertise(channels::kSonarScan)),
      truths_(bus.advertise(channels::kSimBaseTruth)),
      odometries_(bus.advertise(channels::kWheelOdometry)) {
  bus.on_each(channels::kBaseCommand, [this](const BaseCommand& message) { on_command(message); });
  const auto await = [&](const auto& channel) {
    if (std::find(awaited.begin(), awaited.end(), channel.name) == awaited.end()) return;
    bus.on_each(channel, [this, name = channel.name](const auto& message) {
      barrier_.observe(name, message.odometry_session, message.odometry_seq);
    });
  };
  await(channels::kBaseStatus);
  await(channels::kRobotPose);
}

void BaseNode::on_command(const BaseCommand& message) {
  const motion::CommandVerdict verdict = simulation_->command_base(
      {messages::stamp_of(message), message.odometry_session}, message.speed, message.turn_rate);
  barrier_.observe(channels::kBaseCommand.name, message.odometry_session, message.odometry_seq);
  switch (verdict) {
    case motion::CommandVerdict::kObeyed:
    case motion::CommandVerdict::kLatched:      // commands go on while the base is stopped
    case motion::CommandVerdict::kBeforeReset:  // and those under way at a reset come late
      break;
    default:
      messages::drop("command for odometry " + std::to_string(message.odometry_seq) + " " + motion::describe(verdict));
  }
}

bool BaseNode::publish_due() {
  const MobileBaseOutputs due = simulation_->take_due();
  for (const TagRound& round : due.rounds) {
    RfidTagHits message = rfid_message(round);
    rounds_.publish(message);
  }
  if (due.scan) {
    scan_ = sonar_message(*due.scan);
    scans_.publish(*scan_);
  }
  if (!due.odometry) return false;
  const int counter_bits = simulation_->robot().base->counter_bits;
  odometry_ = odometry_message(faults_.apply(simulation_->settings().faults, counter_bits, *due.odometry));
  publish_odometry();
  barrier_.expect(odometries_.session(), odometry_seq_);
  return true;
}

void BaseNode::repeat() {
  if (!odometry_) return;
  if (scan_) scans_.publish(*scan_);
  publish_odometry();
  barrier_.expect_also(odometry_seq_);
}

void BaseNode::publish_odometry() {
  ++odometry_seq_;
  const MobileBaseTruth truth = simulation_->base_truth();
  SimBaseTruth truth_message = base_truth_message(truth.base, odometry_->utime, odometry_seq_);
  truth_message.touched = truth.touched ? 1 : 0;
  truth_message.nearest = truth.nearest;
  truths_.publish(truth_message);
  simulation_->observe_odometry();
  odometries_.publish(*odometry_);
}

}  // namespace markservo::simulator
