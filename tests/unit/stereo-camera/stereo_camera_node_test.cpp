// The node on an in-process bus.

#include "services/stereo-camera/stereo_camera_node.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <CLI/CLI.hpp>
#include <markservo/ServiceStatus.hpp>
#include <markservo/StereoFrame.hpp>
#include <opencv2/imgcodecs.hpp>

#include "common/robot/configuration_error.hpp"
#include "tests/unit/bus/memq_bus.hpp"
#include "tests/unit/temporary_folder.hpp"

namespace markservo::stereo_camera {
namespace {

using testing::HasSubstr;

const std::string kRobotFile = MARKSERVO_SOURCE_DIR "/config/robot.yaml";

class StereoCameraOnALiveBus : public testing::Test {
 protected:
  void configure(std::vector<std::string> arguments) {
    node_.add_options(app_);
    std::reverse(arguments.begin(), arguments.end());  // as CLI11 takes them
    app_.parse(arguments);
    node_.configure(kRobotFile);
  }

  test::TemporaryFolder folder_;
  CLI::App app_;
  StereoCameraNode node_;
};

TEST_F(StereoCameraOnALiveBus, PacesPicturesByTheRate) {
  const std::string path = folder_.file("a.png");
  ASSERT_TRUE(cv::imwrite(path, cv::Mat(480, 640, CV_8UC3, cv::Scalar(1, 2, 3))));
  configure({"--left", path, "--right", path, "--rate", "50", "--loop", "--count", "4"});
  bus::Bus bus(bus::memq_parameters("stereo-camera"));
  std::vector<StereoFrame> frames;
  bus.on_each(channels::kStereoFrame, [&](const StereoFrame& frame) { frames.push_back(frame); });
  node_.start(bus);
  node_.run(bus);
  bus.poll(std::chrono::milliseconds(0));
  EXPECT_EQ(node_.published(), 4);
  ASSERT_EQ(frames.size(), 4U);
  for (std::size_t i = 0; i < frames.size(); ++i) {
    EXPECT_EQ(frames[i].session, bus.session());
    EXPECT_EQ(frames[i].seq, static_cast<std::int64_t>(i) + 1);
    // A machine that is too busy may move the schedule, never shorten a period.
    if (i > 0) {
      EXPECT_GE(frames[i].utime - frames[i - 1].utime, 20'000);
    }
  }
}

TEST_F(StereoCameraOnALiveBus, WaitsForACameraThatIsNotThereAndSaysSo) {
  configure({"--device", folder_.file("video0"), "--side-by-side", "--wait-for-device"});
  bus::Bus bus(bus::memq_parameters("stereo-camera"));
  node_.start(bus);
  std::string state;
  bus.every(std::chrono::milliseconds(200), [&] {
    const ServiceStatus status = bus.status();
    if (status.reason.find("no such device") == std::string::npos) return;
    state = status.state;
    bus.stop();
  });
  node_.run(bus);
  EXPECT_EQ(state, "waiting");
}

TEST_F(StereoCameraOnALiveBus, TellsInItsStatusHowManyPairsItDropped) {
  const std::string good = folder_.file("a_0.png");
  ASSERT_TRUE(cv::imwrite(good, cv::Mat(480, 640, CV_8UC3, cv::Scalar(1, 2, 3))));
  folder_.write("a_1.png", "not a picture");
  configure({"--left", folder_.file("a_%d.png"), "--right", folder_.file("a_%d.png"), "--rate", "50", "--loop"});
  bus::Bus bus(bus::memq_parameters("stereo-camera"));
  node_.start(bus);
  std::string reason;
  bus.every(std::chrono::milliseconds(50), [&] {
    reason = bus.status().reason;
    if (!reason.empty()) bus.stop();
  });
  node_.run(bus);
  EXPECT_THAT(reason, HasSubstr("dropped"));
  EXPECT_THAT(reason, HasSubstr("a_1.png"));
  EXPECT_GT(node_.dropped(), 0);
}

}  // namespace
}  // namespace markservo::stereo_camera
