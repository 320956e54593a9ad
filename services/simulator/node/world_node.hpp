#pragma once

// The running simulation on the bus: steps it and sends what its parts tell, in the order in which a real robot's
// messages of one instant come. real_time_node and lockstep_node decide when.

#include <cstdint>
#include <markservo/channels.hpp>
#include <memory>
#include <string>

#include "common/bus/bus.hpp"
#include "services/simulator/node/arm_node.hpp"
#include "services/simulator/node/control_node.hpp"
#include "services/simulator/node/frame_node.hpp"
#include "services/simulator/node/run_state.hpp"
#include "services/simulator/node/stop_node.hpp"
#include "services/simulator/time/awaited_channels.hpp"
#include "services/simulator/time/lockstep_barrier.hpp"
#include "services/simulator/world/simulation.hpp"

namespace markservo::simulator {

class BaseNode;

class WorldNode {
 public:
  // `simulation` and `cameras` outlive this. `awaited` answers are observed for lockstep. `jpeg_quality` as
  // FrameNode's.
  WorldNode(bus::Bus& bus, Simulation& simulation, Cameras& cameras, const AwaitedChannels& awaited, int jpeg_quality);
  ~WorldNode();
  WorldNode(const WorldNode&) = delete;
  WorldNode& operator=(const WorldNode&) = delete;

  // Lets a step pass and sends what arm and stop tell after it. Where physics diverged, the world begins anew and the
  // run is invalid.
  void step();
  // Whether JOINT_STATE is due by its own period.
  bool joint_state_due() const;

  // True at the start, in a new world, and when the cameras expose.
  bool frame_due() const;
  // Exposes a frame and sends it, after what belongs to it. While time stands still it sends the same frame again under
  // another number: nobody was there to answer.
  void expose_frame();

  // Sends what of the base has become due. True if an odometry went out.
  bool publish_base();
  // Sends the newest odometry again: nobody was there to answer. Only of a robot with a base.
  void repeat_odometry();

  void tell_of_a_latch() { stops_.tell_of_a_latch(); }

  // The run is not what it should be, until the next reset.
  void invalidate() { run_.valid = false; }

  const Simulation& simulation() const { return *simulation_; }
  const RunState& run() const { return run_; }
  // Whether the awaited channels have answered the newest frame, and the newest odometry (of a robot with a base).
  const LockstepBarrier& frame_barrier() const { return frame_barrier_; }
  const LockstepBarrier& odometry_barrier() const;

 private:
  void await_channel(bus::Bus& bus, const std::string& channel);
  void on_joint_command(const JointCommand& message);
  void on_control(const SimControl& message);

  Simulation* simulation_;
  RunState run_;
  LockstepBarrier frame_barrier_;
  FrameNode frames_;
  ArmNode arm_;
  StopNode stops_;
  ControlNode control_;
  std::unique_ptr<BaseNode> base_;  // null: the robot has none
  std::int64_t frame_seq_ = 0;      // of the newest frame; 0 before the first
  std::int64_t exposed_utime_ = 0;  // us, likewise
};

}  // namespace markservo::simulator
