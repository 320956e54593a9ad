// Real photographs through the real executables: the aloe pair of Debian's opencv-doc, with its measured disparities.

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <markservo/StereoMatches.hpp>
#include <opencv2/imgcodecs.hpp>
#include <set>

#include "common/bus/safe_decode.hpp"
#include "tests/replay/replay_run.hpp"
#include "tests/unit/log_events.hpp"

namespace markservo::replay {
namespace {

using test::events_of;

const std::string kPictures = "/usr/share/doc/opencv-doc/examples/data/";
const std::string kRobotFile = MARKSERVO_SOURCE_DIR "/tests/replay/aloe_robot.yaml";
constexpr int kTilesAcross = 8;

TEST(RealPhotographs, LeavesAreMatchedWithinAPixelOfTheTruth) {
  const cv::Mat truth = cv::imread(kPictures + "aloeGT.png", cv::IMREAD_GRAYSCALE);
  ASSERT_FALSE(truth.empty()) << kPictures << "aloeGT.png is not there: install Debian's opencv-doc";
  const TemporaryFolder folder;
  ASSERT_EQ(run_service_alone(
                folder, "stereo-camera",
                {"--robot-file", kRobotFile, "--left", kPictures + "aloeL.jpg", "--right", kPictures + "aloeR.jpg",
                 "--encoding", "raw", "--lcm-out", "file://" + folder.path("frames.lcm") + "?mode=w"}),
            0);
  ASSERT_EQ(run_through(folder, "mark-detector", "frames.lcm", "detections.lcm",
                        {"--robot-file", kRobotFile, "--patch-limit", "2000"}),
            0);
  ASSERT_EQ(run_through(folder, "target-locator", "detections.lcm", "poses.lcm",
                        {"--robot-file", kRobotFile, "--max-features", "1500", "--disparity-min", "40",
                         "--disparity-max", "215"}),
            0);

  int known = 0;
  int right_ones = 0;
  std::set<int> tiles;
  for (const auto& [channel, payload] : events_of(folder.path("poses.lcm"))) {
    if (channel != "STEREO_MATCHES") continue;
    const auto decoded = bus::safe_decode<StereoMatches>(payload.data(), payload.size());
    ASSERT_TRUE(decoded.ok) << decoded.error;
    for (const auto& mark : decoded.message.marks) {
      for (std::size_t i = 0; i < mark.u_left.size(); ++i) {
        const int column = static_cast<int>(std::lround(mark.u_left[i]));
        const int row = static_cast<int>(std::lround(mark.v_left[i]));
        const int disparity = truth.at<std::uint8_t>(row, column);
        if (disparity == 0) continue;  // the truth is not known there
        ++known;
        right_ones += std::abs(mark.u_left[i] - mark.u_right[i] - disparity) <= 1.0 ? 1 : 0;
        tiles.insert(row * kTilesAcross / truth.rows * kTilesAcross + column * kTilesAcross / truth.cols);
      }
    }
  }
  RecordProperty("matches", known);
  RecordProperty("within_1_px", right_ones);
  std::printf("%d matches with known truth over %zu of 64 tiles, %.1f%% within 1 px\n", known, tiles.size(),
              100.0 * right_ones / std::max(known, 1));
  EXPECT_GE(known, 300);
  EXPECT_GE(tiles.size(), 20U) << "spread over the leaves";
  EXPECT_GE(right_ones, 0.9 * known);
}

}  // namespace
}  // namespace markservo::replay
