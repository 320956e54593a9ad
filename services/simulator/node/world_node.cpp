#include "services/simulator/node/world_node.hpp"

#include <markservo/JointCommand.hpp>
#include <markservo/MarkDetection.hpp>
#include <markservo/ServoStatus.hpp>
#include <markservo/SimControl.hpp>
#include <markservo/StopRequest.hpp>
#include <markservo/TargetPose.hpp>
#include <markservo/TaskState.hpp>
#include <stdexcept>

#include "common/logging/log.hpp"
#include "services/simulator/node/base_node.hpp"

namespace markservo::simulator {
namespace {

constexpr std::int64_t kJointStatePeriod_us = 10'000;

}  // namespace

WorldNode::WorldNode(bus::Bus& bus, Simulation& simulation, Cameras& cameras, const AwaitedChannels& awaited,
                     int jpeg_quality)
    : simulation_(&simulation),
      frame_barrier_(awaited.of_frames),
      frames_(bus, simulation, cameras, jpeg_quality),
      arm_(bus, simulation),
      stops_(bus, simulation, run_),
      control_(bus, simulation, run_) {
  // Messages that wait are handed over in the order in which their channels are subscribed.
  bus.on_each(channels::kJointCommand, [this](const JointCommand& message) { on_joint_command(message); });
  bus.on_each(channels::kStop, [this](const StopRequest& message) { stops_.on_stop(message); });
  bus.on_each(channels::kSimControl, [this](const SimControl& message) { on_control(message); });
  if (simulation.has_base()) base_ = std::make_unique<BaseNode>(bus, simulation, awaited.of_odometries);
  for (const std::string& channel : awaited.of_frames) await_channel(bus, channel);
}

WorldNode::~WorldNode() = default;

void WorldNode::await_channel(bus::Bus& bus, const std::string& channel) {
  const auto await = [&](const auto& awaited) {
    if (channel != awaited.name) return;
    bus.on_each(awaited, [this, channel](const auto& message) {
      frame_barrier_.observe(channel, message.frame_session, message.frame_seq);
    });
  };
  await(channels::kTaskState);
  await(channels::kServoStatus);
  await(channels::kTargetPose);
  await(channels::kMarkDetection);
  // JOINT_COMMAND and SIM_CONTROL are subscribed anyway; their handlers tell the barrier.
}

void WorldNode::on_joint_command(const JointCommand& message) {
  const CommandAnswer answer = arm_.on_command(message);
  frame_barrier_.observe(channels::kJointCommand.name, message.frame_session, message.frame_seq);
  stops_.tell_of_a_latch();
  arm_.drop_unless_obeyed(message, answer);
}

void WorldNode::on_control(const SimControl& message) {
  if (message.kind == SimControl::STEP) {
    frame_barrier_.observe(channels::kSimControl.name, message.frame_session, message.frame_seq);
  } else {
    control_.on_control(message);
  }
}

void WorldNode::step() {
  try {
    simulation_->step();
  } catch (const std::runtime_error& error) {
    logging::error("{}: the world begins anew, this run is invalid", error.what());
    simulation_->reset(simulation_->seed(), {});
    run_.begin_anew(false);
  }
  const bool exposure = simulation_->frame_due();  // then the joints are told at the exposure itself
  if (exposure || joint_state_due()) arm_.publish();
  stops_.repeat();
}

bool WorldNode::joint_state_due() const {
  return simulation_->elapsed_us() % kJointStatePeriod_us == 0;
}

bool WorldNode::frame_due() const {
  return run_.world_is_new || frame_seq_ == 0 || simulation_->frame_due();
}

void WorldNode::expose_frame() {
  const bool repeated = frame_seq_ > 0 && !run_.world_is_new && exposed_utime_ == simulation_->utime();
  if (run_.world_is_new || repeated || frame_seq_ == 0) {
    arm_.publish();
    stops_.publish();
  }
  run_.world_is_new = false;
  simulation_->expose(++frame_seq_);
  exposed_utime_ = simulation_->utime();
  if (repeated) {
    frame_barrier_.expect_also(frame_seq_);
  } else {
    frame_barrier_.expect(frames_.session(), frame_seq_);
  }
  control_.tell_truth(frames_.session(), frame_seq_);
  frames_.publish();
}

bool WorldNode::publish_base() {
  return base_ && base_->publish_due();
}

void WorldNode::repeat_odometry() {
  stops_.publish();
  base_->repeat();
}

const LockstepBarrier& WorldNode::odometry_barrier() const {
  return base_->barrier();
}

}  // namespace markservo::simulator
