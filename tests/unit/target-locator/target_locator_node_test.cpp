// The node on an in-process bus.

#include "services/target-locator/target_locator_node.hpp"

#include <gtest/gtest.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdint>
#include <markservo/DetectedMark.hpp>
#include <markservo/LocatedMark.hpp>
#include <markservo/MarkDetection.hpp>
#include <markservo/MarkView.hpp>
#include <markservo/StereoMatches.hpp>
#include <markservo/TargetPose.hpp>

#include "common/robot/configuration_error.hpp"
#include "services/target-locator/pose_message.hpp"
#include "tests/unit/bus/memq_bus.hpp"
#include "tests/unit/target-locator/synthetic_mark.hpp"

namespace markservo::target_locator {
namespace {

const std::string kRobotFile = MARKSERVO_SOURCE_DIR "/config/robot.yaml";

MarkView message_of(const test::RenderedView& rendered) {
  MarkView message{};
  const View& view = rendered.view;
  message.seen = view.seen ? 1 : 0;
  message.clipped = view.clipped ? 1 : 0;
  message.x = static_cast<std::int32_t>(view.x);
  message.y = static_cast<std::int32_t>(view.y);
  message.width = static_cast<std::int32_t>(view.width);
  message.height = static_cast<std::int32_t>(view.height);
  message.patch.x = static_cast<std::int32_t>(view.patch.frame.x);
  message.patch.y = static_cast<std::int32_t>(view.patch.frame.y);
  message.patch.scale = static_cast<std::int32_t>(view.patch.frame.scale);
  message.patch.width = view.patch.width;
  message.patch.height = view.patch.height;
  message.patch.bgr = rendered.bgr;
  message.patch.bgr_size = static_cast<std::int32_t>(rendered.bgr.size());
  message.patch.mask = rendered.mask;
  message.patch.mask_size = static_cast<std::int32_t>(rendered.mask.size());
  return message;
}

MarkDetection detection_of(const test::Scene& scene, const std::vector<std::string>& names) {
  MarkDetection detection{};
  detection.utime = detection.frame_utime = 1'000'000;
  detection.session = 5;
  detection.seq = 1;
  detection.frame_session = 7;
  detection.frame_seq = 42;
  detection.width = 640;
  detection.height = 480;
  const auto& c = scene.camera;
  detection.calibration.fx = c.fx;
  detection.calibration.fy = c.fy;
  detection.calibration.cx_left = c.cx_left;
  detection.calibration.cx_right = c.cx_right;
  detection.calibration.cy = c.cy;
  detection.calibration.baseline = c.baseline;
  const auto rendered = render(scene);
  for (const std::string& name : names) {
    DetectedMark mark{};
    mark.name = name;
    mark.role = DetectedMark::ROLE_TARGET;
    mark.left = message_of(rendered.left);
    mark.right = message_of(rendered.right);
    detection.marks.push_back(mark);
  }
  detection.num_marks = static_cast<std::int32_t>(detection.marks.size());
  return detection;
}

class TargetLocatorOnABus : public testing::Test {
 protected:
  TargetLocatorOnABus() : bus_(bus::memq_parameters("target-locator")) { node_.add_options(app_); }

  void start(std::vector<std::string> arguments = {}) {
    std::reverse(arguments.begin(), arguments.end());  // as CLI11 takes them
    app_.parse(arguments);
    node_.configure(kRobotFile);
    detections_.emplace(bus_.advertise(channels::kMarkDetection));
    bus_.on_each(channels::kTargetPose, [this](const TargetPose& pose) { poses_.push_back(pose); });
    bus_.on_each(channels::kStereoMatches, [this](const StereoMatches& matches) { matches_.push_back(matches); });
    node_.start(bus_);
  }

  void send(MarkDetection detection) {
    detections_->publish(detection);
    settle(bus_);
  }

  CLI::App app_;
  TargetLocatorNode node_;
  bus::Bus bus_;
  std::optional<bus::Publisher<MarkDetection>> detections_;
  std::vector<TargetPose> poses_;
  std::vector<StereoMatches> matches_;
};

TEST_F(TargetLocatorOnABus, AnswersADetectionWithOnePoseAndOneSetOfMatches) {
  start();
  test::Scene scene;
  send(detection_of(scene, {"red_book"}));
  ASSERT_EQ(poses_.size(), 1U);
  ASSERT_EQ(matches_.size(), 1U);
  const TargetPose& pose = poses_[0];
  EXPECT_EQ(pose.utime, 1'000'000);
  EXPECT_EQ(pose.frame_session, 7);
  EXPECT_EQ(pose.frame_seq, 42);
  EXPECT_EQ(matches_[0].frame_seq, 42);
  ASSERT_EQ(pose.num_marks, 1);
  const LocatedMark& mark = pose.marks[0];
  EXPECT_EQ(mark.name, "red_book");
  EXPECT_EQ(mark.status, LocatedMark::LOCATED);
  EXPECT_EQ(mark.cue, LocatedMark::CUE_TEXTURE);
  EXPECT_NEAR(mark.p_C.x, scene.centre.x(), 0.2e-3);
  EXPECT_NEAR(mark.p_C.y, scene.centre.y(), 0.2e-3);
  EXPECT_NEAR(mark.p_C.z, scene.centre.z(), 0.2e-3);
  EXPECT_GT(mark.covariance.yy, 0.0);
  EXPECT_LT(mark.normal_C.y, -0.99);
  EXPECT_EQ(mark.num_features, matches_[0].marks[0].num_matches);
  EXPECT_GT(mark.num_features, 10);
}

TEST_F(TargetLocatorOnABus, SaysThatAPlainMarkIsMeasuredByItsOutline) {
  start();
  test::Scene scene;
  scene.texture_depth = 0.0;
  send(detection_of(scene, {"red_book"}));
  ASSERT_EQ(poses_.size(), 1U);
  EXPECT_EQ(poses_[0].marks[0].status, LocatedMark::LOCATED);
  EXPECT_EQ(poses_[0].marks[0].cue, LocatedMark::CUE_OUTLINE);
  EXPECT_EQ(matches_[0].marks[0].num_matches, poses_[0].marks[0].num_features);
}

TEST_F(TargetLocatorOnABus, GivesNoCueOfWhatIsNotLocated) {
  start();
  MarkDetection detection = detection_of({}, {"red_book"});
  detection.marks[0].right = MarkView{};
  send(detection);
  ASSERT_EQ(poses_.size(), 1U);
  EXPECT_EQ(poses_[0].marks[0].status, LocatedMark::SEEN_BY_ONE);
  EXPECT_EQ(poses_[0].marks[0].cue, LocatedMark::CUE_NONE);
}

TEST_F(TargetLocatorOnABus, AnswersWithoutMarksToo) {
  start();
  send(detection_of({}, {}));
  ASSERT_EQ(poses_.size(), 1U);
  EXPECT_EQ(poses_[0].num_marks, 0);
  EXPECT_EQ(matches_.size(), 1U);
}

TEST_F(TargetLocatorOnABus, ListsUnseenMarks) {
  start();
  MarkDetection detection = detection_of({}, {"red_book", "hand"});
  detection.marks[1].left = MarkView{};
  detection.marks[1].right = MarkView{};
  send(detection);
  ASSERT_EQ(poses_.size(), 1U);
  ASSERT_EQ(poses_[0].num_marks, 2);
  EXPECT_EQ(poses_[0].marks[0].status, LocatedMark::LOCATED);
  EXPECT_EQ(poses_[0].marks[1].status, LocatedMark::UNSEEN);
}

TEST_F(TargetLocatorOnABus, KeepsThePoseWithinOnePacket) {
  start();
  std::vector<std::string> names;
  for (int k = 0; k < 20; ++k) names.push_back("a_mark_with_a_rather_long_name_" + std::to_string(k));
  send(detection_of({}, names));
  ASSERT_EQ(poses_.size(), 1U);
  EXPECT_LE(poses_[0].getEncodedSize(), kMaxPoseBytes);
  EXPECT_GE(poses_[0].num_marks, 8);
  EXPECT_EQ(matches_[0].num_marks, 20);
}

TEST_F(TargetLocatorOnABus, TreatsASurfaceAsFreeWhenToldSo) {
  start({"--surface", "red_book=free"});
  send(detection_of({}, {"red_book"}));
  ASSERT_EQ(poses_.size(), 1U);
  EXPECT_EQ(poses_[0].marks[0].status, LocatedMark::LOCATED);
  EXPECT_EQ(poses_[0].marks[0].normal_C.y, 0.0);
}

TEST_F(TargetLocatorOnABus, OffersThePapersMethod) {
  start({"--method", "paper"});
  send(detection_of({}, {"red_book"}));
  ASSERT_EQ(poses_.size(), 1U);
  EXPECT_EQ(poses_[0].marks[0].status, LocatedMark::LOCATED);
  EXPECT_EQ(poses_[0].marks[0].normal_C.y, 0.0);
}

TEST(TargetLocatorSettings, RefuseWhatCannotBe) {
  const std::vector<std::vector<std::string>> wrong = {
      {"--surface", "red_book"}, {"--surface", "red_book=round"}, {"--disparity-min", "50", "--disparity-max", "40"}};
  for (auto arguments : wrong) {
    CLI::App app;
    TargetLocatorNode node;
    node.add_options(app);
    std::reverse(arguments.begin(), arguments.end());
    app.parse(arguments);
    EXPECT_THROW(node.configure(kRobotFile), ConfigurationError);
  }
}

}  // namespace
}  // namespace markservo::target_locator
