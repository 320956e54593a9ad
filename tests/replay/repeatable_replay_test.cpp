// A recorded log through the real executables twice: the same sequence of (channel, payload), and right answers.

#include <gtest/gtest.h>

#include <cstdint>
#include <cstdio>
#include <fstream>
#include <lcm/lcm-cpp.hpp>
#include <map>
#include <markservo/SimTruth.hpp>
#include <markservo/TargetPose.hpp>

#include "common/bus/safe_decode.hpp"
#include "tests/experiments/experiment.hpp"
#include "tests/experiments/rig.hpp"
#include "tests/replay/replay_run.hpp"
#include "tests/unit/log_events.hpp"

namespace markservo::replay {
namespace {

using test::events_of;

const std::string kRobotFile = MARKSERVO_SOURCE_DIR "/config/robot.yaml";
constexpr int kFrames = 6;

// Frames of the simulated robot, as an LCM recording, with what was true.
std::map<std::int64_t, SimTruth> record_frames(const TemporaryFolder& folder, const std::string& log_name) {
  experiments::ExperimentOptions options;
  options.out = folder.path("");
  options.robot_file = kRobotFile;
  options.scene = MARKSERVO_SOURCE_DIR "/config/scenes/shelf.yaml";
  // A port of its own, so that tests may run beside each other.
  options.lcm_url = "udpm://239.255.76.67:" + std::to_string(21000 + getpid() % 10000) + "?ttl=0&recv_buf_size=4194304";
  experiments::Services services(options);
  services.start_simulator("");
  experiments::Rig rig(options.lcm_url, "");
  lcm::LCM log("file://" + folder.path(log_name) + "?mode=w");
  StereoFrame frame{};
  rig.bus().on_each(channels::kStereoFrame, [&](const StereoFrame& message) { frame = message; });
  rig.wait_for_world();
  rig.reset(3, {});
  std::map<std::int64_t, SimTruth> truths;
  for (int i = 0; i < kFrames; ++i) {
    rig.step([&] { return frame.seq == rig.truth().frame_seq; });
    while (frame.seq != rig.truth().frame_seq) rig.bus().poll(std::chrono::milliseconds(20));
    log.publish("STEREO_FRAME", &frame);
    truths[frame.seq] = rig.truth();
  }
  return truths;
}

TEST(Replay, OfARecordedLogThroughPerceptionIsTheSameTwice) {
  const TemporaryFolder folder;
  const auto truths = record_frames(folder, "frames.lcm");
  const std::vector<std::string> robot{"--robot-file", kRobotFile};
  for (const std::string run : {"a", "b"}) {
    ASSERT_EQ(run_through(folder, "mark-detector", "frames.lcm", "detections-" + run + ".lcm", robot), 0);
    ASSERT_EQ(run_through(folder, "target-locator", "detections-a.lcm", "poses-" + run + ".lcm", robot), 0);
  }
  const auto detections = events_of(folder.path("detections-a.lcm"));
  EXPECT_EQ(detections.size(), static_cast<std::size_t>(kFrames));
  EXPECT_TRUE(detections == events_of(folder.path("detections-b.lcm"))) << "mark-detector's answers differ";
  const auto poses = events_of(folder.path("poses-a.lcm"));
  EXPECT_EQ(poses.size(), static_cast<std::size_t>(2 * kFrames)) << "a TARGET_POSE and a STEREO_MATCHES for each frame";
  EXPECT_TRUE(poses == events_of(folder.path("poses-b.lcm"))) << "target-locator's answers differ";

  // What is the same must also be right.
  int located = 0;
  for (const auto& [channel, payload] : poses) {
    if (channel != "TARGET_POSE") continue;
    const auto decoded = bus::safe_decode<TargetPose>(payload.data(), payload.size());
    ASSERT_TRUE(decoded.ok) << decoded.error;
    EXPECT_LE(payload.size(), 1400U) << "more than one network packet";
    for (const auto& mark : decoded.message.marks) {
      for (const auto& truth : truths.at(decoded.message.frame_seq).marks) {
        if (truth.name != mark.name || mark.status != LocatedMark::LOCATED) continue;
        ++located;
        EXPECT_NEAR(mark.p_C.x, truth.p_C.x, 0.001) << mark.name;
        EXPECT_NEAR(mark.p_C.y, truth.p_C.y, 0.001) << mark.name;
        EXPECT_NEAR(mark.p_C.z, truth.p_C.z, 0.001) << mark.name;
      }
    }
  }
  EXPECT_GE(located, 2 * kFrames) << "the books' marks";

  // The example that users copy reads the same log.
  std::vector<std::string> watched = robot;
  watched.insert(watched.end(), {"--mark", "red_book"});
  ASSERT_EQ(run_through(folder, "mark-watcher", "poses-a.lcm", "nothing.lcm", watched), 0);
  std::ifstream lines(folder.path("mark-watcher.log"));
  int printed = 0;
  for (std::string line; std::getline(lines, line);) {
    double x = 0.0;
    double y = 0.0;
    double z = 0.0;
    printed += std::sscanf(line.c_str(), "red_book x=%lf m y=%lf m z=%lf m", &x, &y, &z) == 3 ? 1 : 0;
  }
  EXPECT_EQ(printed, kFrames);
}

}  // namespace
}  // namespace markservo::replay
