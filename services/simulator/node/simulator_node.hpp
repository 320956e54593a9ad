#pragma once

#include <chrono>
#include <cstdint>
#include <markservo/JointCommand.hpp>
#include <markservo/JointState.hpp>
#include <markservo/SimControl.hpp>
#include <markservo/SimTruth.hpp>
#include <markservo/StereoFrame.hpp>
#include <markservo/StopRequest.hpp>
#include <markservo/StopState.hpp>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "common/bus/repeat_timer.hpp"
#include "common/bus/service.hpp"
#include "common/motion/command_inbox.hpp"
#include "services/simulator/cameras/stereo_renderer.hpp"
#include "services/simulator/faults/lying_sensors.hpp"
#include "services/simulator/node/base_node.hpp"
#include "services/simulator/node/picture_options.hpp"
#include "services/simulator/time/lockstep_barrier.hpp"
#include "services/simulator/time/lockstep_node.hpp"
#include "services/simulator/world/simulation.hpp"

namespace markservo::simulator {

// The simulated robot on the bus: STEREO_FRAME, JOINT_STATE, STOP_STATE and SIM_TRUTH out, and what its base says;
// JOINT_COMMAND, BASE_COMMAND, STOP and SIM_CONTROL in. Real time unless --lockstep.
class SimulatorNode : public bus::Service {
 public:
  void add_options(CLI::App& app) override;
  void configure(const std::string& robot_file) override;
  std::optional<int> run_alone() override;
  void start(bus::Bus& bus) override;
  void run(bus::Bus& bus) override;

 private:
  void subscribe(bus::Bus& bus);
  void await_channel(bus::Bus& bus, const std::string& channel);
  void choose_encoding(const bus::BusUrls& urls);

  void on_joint_command(const JointCommand& message);
  void on_stop(const StopRequest& message);
  void on_control(const SimControl& message);
  void obey_control(const SimControl& message);

  void run_lockstep(bus::Bus& bus);
  void run_real_time(bus::Bus& bus);
  // Until all awaited channels answered, the wait timed out, or the world was reset. False when the service shall end.
  bool wait_for_answers(bus::Bus& bus, LockstepNode& wait, const LockstepBarrier& barrier, const char* what);

  void step();
  void expose_frame();
  void publish_truth();
  void publish_joint_state();
  void publish_stop_states();
  void tell_of_a_latch();
  // True if an odometry went out.
  bool publish_base();
  void repeat_odometry();
  ImagePair draw();

  std::string scene_file_ = "config/scenes/shelf.yaml";
  std::int64_t seed_ = 1;
  bool lockstep_ = false;
  std::vector<std::string> wait_for_ = {channels::kJointCommand.name};
  double lockstep_timeout_s_ = 5.0;
  std::string encoding_ = "auto";
  int jpeg_quality_ = 90;
  std::vector<std::string> assignments_;
  PictureOptions pictures_;
  bool list_settings_ = false;

  std::string robot_file_;
  robot::RobotDescription robot_;
  Scene scene_;
  Settings settings_;
  std::unique_ptr<Simulation> simulation_;
  LyingSensors lying_;
  std::unique_ptr<StereoRenderer> renderer_;

  std::optional<bus::Publisher<StereoFrame>> frames_;
  std::optional<bus::Publisher<JointState>> joint_states_;
  std::optional<bus::Publisher<StopState>> stop_states_;
  std::optional<bus::Publisher<SimTruth>> truths_;
  std::unique_ptr<BaseNode> base_;  // null: the robot has none
  LockstepBarrier barrier_{{}};     // of frames
  motion::CommandInbox controls_{"SIM_CONTROL", "the simulated world"};
  bus::RepeatTimer stop_state_timer_{bus::kStateRepeat_us};
  bool told_latched_ = true;
  std::string control_error_;
  SimTruth truth_{};  // of the newest frame
  std::int64_t frame_seq_ = 0;
  bool raw_ = true;
  bool valid_ = true;
  bool world_is_new_ = false;  // after a reset: a frame is due at once
  std::int64_t resets_ = 0;
  std::int64_t resets_before_wait_ = 0;
  LockstepNode frame_wait_{[this] { expose_frame(); }, [this] { return resets_ != resets_before_wait_; }};
  LockstepNode odometry_wait_{[this] { repeat_odometry(); }, [this] { return resets_ != resets_before_wait_; }};
};

}  // namespace markservo::simulator
