// Sends STEREO_FRAME at a camera's rate and JOINT_STATE twice as often, from pictures in memory; says what it sent.

#include <CLI/CLI.hpp>
#include <chrono>
#include <csignal>
#include <cstdint>
#include <iostream>
#include <lcm/lcm-cpp.hpp>
#include <markservo/StereoFrame.hpp>
#include <markservo/channels.hpp>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "common/bus/bus_url.hpp"
#include "common/bus/option_checks.hpp"
#include "common/bus/publisher.hpp"
#include "common/bus/session.hpp"
#include "common/robot/configuration_error.hpp"
#include "common/robot/robot_description.hpp"
#include "common/time/clocks.hpp"
#include "tests/bench/bench_marks.hpp"
#include "tests/bench/latency/recorded_frames.hpp"
#include "tests/bench/lcm_sink.hpp"
#include "tests/bench/resting_arm.hpp"
#include "tests/scenes/stereo_scene.hpp"

namespace markservo::bench {
namespace {

using Clock = std::chrono::steady_clock;

struct Options {
  std::string robot_file = "config/robot.yaml";
  std::string lcm_url = bus::kDefaultUrl;
  std::string prefix;
  double rate = 30.0;     // frames a second
  double seconds = 60.0;  // 0: until told to end
  int pairs = 12;         // different ones; 1.84 MB each
  bool jpeg = false;
};

volatile std::sig_atomic_t g_stopped = 0;

std::vector<StereoFrame> make_frames(const Options& options, const robot::RobotDescription& robot) {
  scenes::SceneParameters scene;
  scene.num_pairs = options.pairs;
  scene.num_layouts = 1;
  return record_frames(scenes::render_pairs(robot.cameras, choose_marks(robot, options.robot_file), scene),
                       robot.cameras.stereo, options.jpeg ? Encoding::kJpeg : Encoding::kRaw);
}

int run(const Options& options) {
  const robot::RobotDescription robot = robot::load_robot_description(options.robot_file);
  if (!robot.arm) throw ConfigurationError(options.robot_file + ": arm: missing; allowed: an arm");
  std::vector<StereoFrame> frames = make_frames(options, robot);
  JointState joints = resting_arm(robot.arm->home);

  lcm::LCM lcm(options.lcm_url);
  if (!lcm.good()) throw std::runtime_error("bus " + options.lcm_url + ": cannot be joined");
  LcmSink sink(&lcm);
  const std::int64_t session = bus::random_session();
  const std::string prefix = options.prefix.empty() ? "" : options.prefix + "/";
  bus::Publisher<StereoFrame> frame_channel(&sink, prefix + channels::kStereoFrame.name, session);
  bus::Publisher<JointState> joint_channel(&sink, prefix + channels::kJointState.name, session);
  std::cout << "sending" << std::endl;

  const auto half = std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(0.5 / options.rate));
  const auto end =
      Clock::now() + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(options.seconds));
  std::int64_t num_frames = 0;
  std::int64_t num_joint_states = 0;
  for (auto due = Clock::now(); g_stopped == 0 && (options.seconds == 0.0 || due < end); due += half) {
    std::this_thread::sleep_until(due);
    joints.utime = wall_clock_us();
    joint_channel.publish(joints);
    if (num_joint_states++ % 2 != 0) continue;
    StereoFrame& frame = frames[static_cast<std::size_t>(num_frames++) % frames.size()];
    frame.utime = joints.utime;
    frame_channel.publish(frame);
  }
  std::cout << "STEREO_FRAME " << num_frames << "\nJOINT_STATE " << num_joint_states << std::endl;
  return 0;
}

}  // namespace
}  // namespace markservo::bench

int main(int argc, char** argv) {
  using namespace markservo;
  bench::Options options;
  CLI::App app("Sends STEREO_FRAME and JOINT_STATE from pictures in memory; prints how many of each.");
  app.add_option("--robot-file", options.robot_file, "The robot's description")->capture_default_str();
  app.add_option("--lcm-url", options.lcm_url, "LCM bus")->envname("MARKSERVO_LCM_URL")->capture_default_str();
  app.add_option("--robot", options.prefix, "Prefix of the channels");
  app.add_option("--rate", options.rate, "Frames a second")
      ->check(markservo::bus::Within(0.1, 1000.0))
      ->capture_default_str();
  app.add_option("--seconds", options.seconds, "0: until told to end")
      ->check(markservo::bus::Within(0.0, 1e6))
      ->capture_default_str();
  app.add_option("--pairs", options.pairs, "Different pictures, sent in turn")
      ->check(CLI::Range(1, 1000))
      ->capture_default_str();
  app.add_flag("--jpeg", options.jpeg, "Send JPEG, not raw pictures");
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  }
  const auto stop = [](int) { bench::g_stopped = 1; };
  std::signal(SIGINT, stop);
  std::signal(SIGTERM, stop);
  try {
    return bench::run(options);
  } catch (const ConfigurationError& error) {
    std::cerr << "frame-source: " << error.what() << "\n";
    return 2;
  } catch (const std::exception& error) {
    std::cerr << "frame-source: " << error.what() << "\n";
    return 1;
  }
}
