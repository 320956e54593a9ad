// rfid-localizer on a bus: what it answers to whom, in reply to messages in any order.

#include "services/rfid-localizer/rfid_localizer_node.hpp"

#include <gtest/gtest.h>

#include <markservo/PaperLocalisation.hpp>
#include <markservo/RfidTagHit.hpp>
#include <markservo/RfidTagHits.hpp>
#include <markservo/RobotPose.hpp>
#include <markservo/ServiceStatus.hpp>
#include <markservo/WheelOdometry.hpp>
#include <vector>

#include "common/bus/log_format.hpp"
#include "common/robot/configuration_error.hpp"
#include "tests/unit/bus/node_on_a_bus.hpp"
#include "tests/unit/rfid-localizer/ideal_drive.hpp"
#include "tests/unit/rfid-localizer/skidding_drive.hpp"

namespace markservo::rfid_localizer {
namespace {

using test::IdealDrive;

class RfidLocalizerOnABus : public bus::NodeOnABus<RfidLocalizerNode> {
 protected:
  RfidLocalizerOnABus() : NodeOnABus("rfid-localizer") {}

  void start(const std::string& options = "") {
    start_node(options);
    collect(channels::kRobotPose, poses_);
  }

  // The drive's messages up to `time` (s), in order.
  void drive(double time, bool wheels = true, bool reader = true) {
    while (time_ < time) {
      ++ticks_;
      time_ = 0.02 * static_cast<double>(ticks_);
      if (reader && ticks_ > 10 && ticks_ % 5 == 0) tell(hits_, tampered(drive_.hits((ticks_ - 10) / 5)));
      if (wheels) tell(odometry_, drive_.odometry(ticks_));
    }
  }

  RfidTagHits tampered(RfidTagHits message) const {
    for (int i = 0; i < strangers_; ++i) {
      RfidTagHit hit{};
      hit.uid = "ABCDEF0000000001";
      hit.utime = message.utime;
      message.hits.push_back(hit);
    }
    message.num_hits = static_cast<std::int32_t>(message.hits.size());
    return message;
  }

  bus::Publisher<RfidTagHits> hits_ = bus_.advertise(channels::kRfidTagHits);
  bus::Publisher<WheelOdometry> odometry_ = bus_.advertise(channels::kWheelOdometry);
  IdealDrive drive_{robot::load_robot_description(bus::kRobotFile)};
  std::int64_t ticks_ = 0;
  double time_ = 0.0;
  int strangers_ = 0;  // reads of a tag that the map does not have, in each round
  std::vector<RobotPose> poses_;
};

TEST_F(RfidLocalizerOnABus, AnswersEachOdometryWithOnePoseThatEchoesIt) {
  start();
  tell(odometry_, drive_.odometry(1));
  tell(hits_, drive_.hits(1));  // the wheels take over with the first round
  poses_.clear();
  for (int i = 30; i < 40; ++i) {
    tell(odometry_, drive_.odometry(i));
    ASSERT_EQ(poses_.size(), static_cast<std::size_t>(i - 29));
    EXPECT_EQ(poses_.back().utime, drive_.odometry(i).utime);
    EXPECT_EQ(poses_.back().odometry_session, odometry_.session());
    EXPECT_EQ(poses_.back().odometry_seq, i - 28);
    EXPECT_TRUE(poses_.back().odometry_used);
  }
  tell(hits_, drive_.hits(8));
  EXPECT_EQ(poses_.size(), 10U) << "none for the round";
}

TEST_F(RfidLocalizerOnABus, WithoutEncodersAnswersEachRound) {
  start();
  drive(3.0, false);
  ASSERT_EQ(poses_.size(), 28U);
  EXPECT_EQ(poses_.back().utime, drive_.hits(28).utime);
  EXPECT_EQ(poses_.back().odometry_session, 0);
  EXPECT_EQ(poses_.back().odometry_seq, 0);
  EXPECT_FALSE(poses_.back().odometry_used);
}

TEST_F(RfidLocalizerOnABus, KnowsWhereTheRobotIs) {
  start();
  drive(4.0);
  const RobotPose& pose = poses_.back();
  EXPECT_EQ(pose.state, RobotPose::LOCALISED);
  EXPECT_EQ(pose.reason, "");
  EXPECT_NEAR(pose.pose.x, drive_.x(), 0.03);
  EXPECT_NEAR(pose.pose.y, drive_.y(4.0), 0.03);
  EXPECT_NEAR(pose.pose.heading, 1.5708, 0.15);
  EXPECT_NEAR(pose.speed, 0.4, 0.02);
  EXPECT_NEAR(pose.delay, 0.19, 0.02);
}

TEST_F(RfidLocalizerOnABus, GivesThePapersValuesBesideItsOwn) {
  start();
  drive(4.0);
  const PaperLocalisation& paper = poses_.back().paper;
  EXPECT_TRUE(paper.measured_known);
  EXPECT_TRUE(paper.direction_known);
  EXPECT_EQ(paper.utime, drive_.hits(38).utime);
  EXPECT_NEAR(paper.measured_y, drive_.y(3.8), 0.06) << "late by the delay";
  EXPECT_NEAR(paper.compensated_y - paper.measured_y, 0.4 * 0.19, 0.01);
  EXPECT_NEAR(poses_.back().pose.y, drive_.y(4.0), 0.03) << "the pose is the filter's";
}

TEST_F(RfidLocalizerOnABus, PublishesThePapersPoseWhenAskedTo) {
  start("--method paper");
  drive(0.2);
  EXPECT_EQ(poses_.back().state, RobotPose::SEARCHING);
  drive(4.0);
  const RobotPose& pose = poses_.back();
  EXPECT_EQ(pose.state, RobotPose::LOCALISED);
  EXPECT_EQ(pose.pose.x, pose.paper.compensated_x);
  EXPECT_EQ(pose.pose.y, pose.paper.compensated_y);
  EXPECT_EQ(pose.pose.heading, pose.paper.direction);
  EXPECT_FALSE(pose.odometry_used);
  EXPECT_NEAR(std::sqrt(pose.covariance.xx), 0.026, 1e-9);
}

TEST_F(RfidLocalizerOnABus, ThePapersPoseIsLostAsWellWhenTheReaderFallsSilent) {
  start("--method paper");
  drive(3.0);
  drive(6.0, true, false);
  EXPECT_EQ(poses_.back().state, RobotPose::LOST);
  EXPECT_NE(poses_.back().reason.find("no tag"), std::string::npos) << poses_.back().reason;
}

TEST_F(RfidLocalizerOnABus, NamesReadsOfUnknownTagsInItsStatus) {
  start();
  strangers_ = 1;
  drive(4.0);
  EXPECT_EQ(bus_.status().state, "localised");
  EXPECT_NE(bus_.status().reason.find("reads of tags that the map does not have"), std::string::npos)
      << bus_.status().reason;
}

TEST_F(RfidLocalizerOnABus, SaysInItsStatusWhyItIsLost) {
  start();
  drive(3.0);
  EXPECT_EQ(bus_.status().state, "localised");
  drive(6.0, true, false);
  EXPECT_EQ(bus_.status().state, "lost");
  EXPECT_NE(bus_.status().reason.find("no round of the RFID reader"), std::string::npos) << bus_.status().reason;
}

TEST_F(RfidLocalizerOnABus, RefusesWhatComesOutOfOrderAndGoesOn) {
  start();
  drive(3.0);
  const auto poses = poses_.size();
  tell(odometry_, drive_.odometry(100));
  tell(hits_, drive_.hits(5));
  EXPECT_EQ(poses_.size(), poses);
  EXPECT_EQ(refused(bus_, "WHEEL_ODOMETRY"), 1);
  EXPECT_EQ(refused(bus_, "RFID_TAG_HITS"), 1);
  drive(3.2);
  EXPECT_EQ(poses_.size(), poses + 10);
  EXPECT_EQ(poses_.back().state, RobotPose::LOCALISED);
}

TEST_F(RfidLocalizerOnABus, TakesItsSettingsFromOptions) {
  start("--delay 0.3 --delay-sigma 0 --start-heading 90 --start-heading-sigma 2");
  drive(1.0);
  EXPECT_NEAR(poses_.back().delay, 0.3, 1e-9);
  EXPECT_NEAR(poses_.back().paper.delay, 0.3, 1e-9);
  EXPECT_NEAR(poses_.back().pose.heading, 1.5708, 0.02);
  EXPECT_NEAR(std::sqrt(poses_.back().covariance.hh), 0.035, 0.005);
}

TEST_F(RfidLocalizerOnABus, SaysNothingOfTheWheelsThatItHasYetToJudgeAfterItsClockWasSetBack) {
  start("--tag-field hall");
  test::SkiddingDrive skidding(robot::load_robot_description(bus::kRobotFile));
  constexpr std::int64_t kSetBack_us = 3'600'000'000;
  ::testing::internal::CaptureStderr();
  bus::set_up_log("rfid-localizer", "info");
  int number = 0;
  while (number < 3000) {
    tell(odometry_, skidding.odometry(++number));
    if (number % 5 == 0) tell(hits_, skidding.hits(number));
  }
  EXPECT_NE(::testing::internal::GetCapturedStderr().find("the wheels are worse"), std::string::npos);

  ::testing::internal::CaptureStderr();
  while (number < 3200) {
    WheelOdometry odometry = skidding.odometry(++number);
    odometry.utime -= kSetBack_us;
    tell(odometry_, odometry);
    RfidTagHits hits = skidding.hits(number);
    hits.utime -= kSetBack_us;
    hits.window_start -= kSetBack_us;
    hits.window_end -= kSetBack_us;
    for (RfidTagHit& hit : hits.hits) hit.utime -= kSetBack_us;
    if (number % 5 == 0) tell(hits_, hits);
  }
  const std::string logged = ::testing::internal::GetCapturedStderr();
  EXPECT_NE(logged.find("localised"), std::string::npos) << logged;
  EXPECT_EQ(logged.find("the wheels"), std::string::npos) << logged;
}

}  // namespace
}  // namespace markservo::rfid_localizer
