// Writes known messages at 10 Hz until it is told to stop, so that a test knows what a tool must show.
//   SERVO_GOAL    --goal-id, --speed
//   TARGET_POSE   one mark at x = --x, y = 0.25, z = 0.0625 m; every tenth message is left out (lost)
//   WHEEL_ODOMETRY  by two writers
//   JOINT_STATE   its last byte is missing: cannot be decoded
//   FOREIGN       a type that is not ours, 24 bytes
//   TASK_COMMAND  the first second only
//   STEREO_FRAME  8 x 4 px

#include <algorithm>
#include <array>
#include <chrono>
#include <csignal>
#include <cstdint>
#include <cstdio>
#include <lcm/lcm-cpp.hpp>
#include <markservo/JointState.hpp>
#include <markservo/ServoGoal.hpp>
#include <markservo/StereoFrame.hpp>
#include <markservo/TargetPose.hpp>
#include <markservo/TaskCommand.hpp>
#include <markservo/WheelOdometry.hpp>
#include <markservo/channels.hpp>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include <CLI/CLI.hpp>

#include "common/bus/bus_url.hpp"
#include "common/bus/publisher.hpp"
#include "common/time/clocks.hpp"

namespace {

using markservo::bus::Publisher;
namespace channels = markservo::channels;

volatile std::sig_atomic_t signalled = 0;

struct Options {
  std::string url = markservo::bus::kDefaultUrl;
  std::int64_t goal_id = 4711;
  double speed = 0.375;           // m/s
  double x = 0.125;               // m
  std::vector<std::string> only;  // channels; empty: all
};

// What the publishers write to.
class Outlet final : public markservo::bus::MessageSink {
 public:
  Outlet(lcm::LCM* lcm, std::vector<std::string> only) : lcm_(lcm), only_(std::move(only)) {}
  bool send(const markservo::bus::Outgoing& message) override {
    if (!only_.empty() && std::find(only_.begin(), only_.end(), message.channel) == only_.end()) return true;
    return lcm_->publish(message.channel, message.data, static_cast<unsigned int>(message.size)) >= 0;
  }

 private:
  lcm::LCM* lcm_;
  std::vector<std::string> only_;
};

class SampleBus {
 public:
  SampleBus(lcm::LCM* lcm, const Options& options)
      : outlet_(lcm, options.only),
        options_(options),
        goals_(&outlet_, channels::kServoGoal.name, 101),
        poses_(&outlet_, channels::kTargetPose.name, 102),
        wheels_(&outlet_, channels::kWheelOdometry.name, 103),
        other_wheels_(&outlet_, channels::kWheelOdometry.name, 104),
        commands_(&outlet_, channels::kTaskCommand.name, 105),
        frames_(&outlet_, channels::kStereoFrame.name, 106) {}

  // All channels once, `round` counting from 0.
  void publish(int round, std::int64_t utime) {
    publish_goal(utime);
    if (round % 10 == 9) {
      poses_.skip();
    } else {
      publish_pose(utime);
    }
    markservo::WheelOdometry odometry{};
    odometry.utime = utime;
    wheels_.publish(odometry);
    other_wheels_.publish(odometry);
    if (round < 10) {
      markservo::TaskCommand command{};
      command.utime = utime;
      command.session = 105;
      command.command_id = 1;
      commands_.publish(command);
    }
    publish_frame(utime);
    publish_broken(utime);
  }

 private:
  void publish_goal(std::int64_t utime) {
    markservo::ServoGoal goal{};
    goal.utime = utime;
    goal.goal_id = options_.goal_id;
    goal.kind = markservo::ServoGoal::SERVO;
    goal.target = "red_book";
    goal.tolerance = 0.001;
    goal.speed = options_.speed;
    goals_.publish(goal);
  }

  void publish_pose(std::int64_t utime) {
    markservo::LocatedMark mark{};
    mark.name = "red_book";
    mark.p_C.x = options_.x;
    mark.p_C.y = 0.25;
    mark.p_C.z = 0.0625;
    markservo::TargetPose pose{};
    pose.utime = utime;
    pose.frame_utime = utime;
    pose.frame_session = 106;
    pose.marks = {mark};
    pose.num_marks = 1;
    poses_.publish(pose);
  }

  void publish_frame(std::int64_t utime) {
    markservo::StereoFrame frame{};
    frame.utime = utime;
    frame.width = 8;
    frame.height = 4;
    frame.encoding = markservo::StereoFrame::ENCODING_BGR8;
    frame.calibration.fx = frame.calibration.fy = 500.0;
    frame.calibration.baseline = 0.1;
    frame.left.assign(std::size_t{8} * 4 * 3, 0);
    frame.right = frame.left;
    frame.left_size = frame.right_size = static_cast<std::int32_t>(frame.left.size());
    frames_.publish(frame);
  }

  void publish_broken(std::int64_t utime) {
    markservo::JointState joints{};
    joints.utime = utime;
    std::vector<std::uint8_t> bytes(static_cast<std::size_t>(joints.getEncodedSize()));
    joints.encode(bytes.data(), 0, static_cast<int>(bytes.size()));
    outlet_.send({channels::kJointState.name, bytes.data(), bytes.size() - 1, utime});
    std::array<std::uint8_t, 24> foreign{};
    foreign.fill(0x5a);
    outlet_.send({"FOREIGN", foreign.data(), foreign.size(), utime});
  }

  Outlet outlet_;
  Options options_;
  Publisher<markservo::ServoGoal> goals_;
  Publisher<markservo::TargetPose> poses_;
  Publisher<markservo::WheelOdometry> wheels_;
  Publisher<markservo::WheelOdometry> other_wheels_;
  Publisher<markservo::TaskCommand> commands_;
  Publisher<markservo::StereoFrame> frames_;
};

}  // namespace

int main(int argc, char** argv) {
  Options options;
  CLI::App app("Writes known messages at 10 Hz", "sample-bus");
  app.add_option("--lcm-url", options.url, "The bus")->envname("MARKSERVO_LCM_URL");
  app.add_option("--goal-id", options.goal_id, "SERVO_GOAL.goal_id");
  app.add_option("--speed", options.speed, "SERVO_GOAL.speed, m/s");
  app.add_option("--only", options.only, "Channels, separated by commas, instead of all")->delimiter(',');
  app.add_option("--x", options.x, "TARGET_POSE.marks[0].p_C.x, m");
  CLI11_PARSE(app, argc, argv);
  std::signal(SIGTERM, [](int) { signalled = 1; });
  std::signal(SIGINT, [](int) { signalled = 1; });
  try {
    lcm::LCM lcm(options.url);
    if (!lcm.good()) throw std::runtime_error(options.url + " cannot be joined");
    SampleBus bus(&lcm, options);
    for (int round = 0; signalled == 0; ++round) {
      bus.publish(round, markservo::wall_clock_us());
      std::this_thread::sleep_for(std::chrono::milliseconds(100));
    }
  } catch (const std::exception& error) {
    std::fprintf(stderr, "sample-bus: %s\n", error.what());
    return 3;
  }
  return 0;
}
