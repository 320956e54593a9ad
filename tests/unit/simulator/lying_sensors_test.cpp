#include "services/simulator/faults/lying_sensors.hpp"

#include <gtest/gtest.h>

namespace markservo::simulator {
namespace {

constexpr int kCounterBits = 16;

OdometryReading reading(std::int32_t left, std::int32_t right, double left_m, double right_m) {
  OdometryReading reading;
  reading.ticks = {left, right};
  reading.left_distance = left_m;
  reading.right_distance = right_m;
  return reading;
}

ImagePair picture(int grey) {
  return {cv::Mat(2, 2, CV_8UC3, cv::Scalar::all(grey)), cv::Mat(2, 2, CV_8UC3, cv::Scalar::all(grey))};
}

TEST(LyingSensors, TellTheTruthByDefault) {
  LyingSensors lying;
  ArmReading arm;
  arm.position = {0.1, 0.2, 0.3};
  EXPECT_EQ(lying.tell(FaultSettings{}, arm).position, arm.position);
  const OdometryReading told = lying.tell(FaultSettings{}, kCounterBits, reading(65535, 7, 1.0, 2.0));
  EXPECT_EQ(told.ticks.left, 65535);
  EXPECT_EQ(told.right_distance, 2.0);
  EXPECT_EQ(lying.show(FaultSettings{}, picture(9)).left.at<cv::Vec3b>(0, 0)[0], 9);
}

TEST(LyingSensors, AFrozenJointStaysWhereItStoodUntilItIsMended) {
  LyingSensors lying;
  FaultSettings settings;
  settings.frozen_joint = 2.0;
  ArmReading arm;
  arm.position = {0.1, 0.2, 0.3};
  EXPECT_EQ(lying.tell(settings, arm).position[1], 0.2);
  arm.position = {0.4, 0.5, 0.6};
  arm.speed = {1.0, 1.0, 1.0};
  const ArmReading told = lying.tell(settings, arm);
  EXPECT_EQ(told.position, robot::JointVector(0.4, 0.2, 0.6));
  EXPECT_EQ(told.speed[1], 0.0);
  EXPECT_EQ(told.speed[0], 1.0);
  EXPECT_EQ(lying.tell(FaultSettings{}, arm).position[1], 0.5);
}

TEST(LyingSensors, AFrozenCameraShowsWhatItSaw) {
  LyingSensors lying;
  FaultSettings settings;
  settings.frozen_camera = 1.0;
  lying.show(settings, picture(10));
  EXPECT_EQ(lying.show(settings, picture(20)).right.at<cv::Vec3b>(1, 1)[2], 10);
  EXPECT_EQ(lying.show(FaultSettings{}, picture(30)).right.at<cv::Vec3b>(1, 1)[2], 30);
}

TEST(LyingSensors, AStuckEncoderDoesNotCountAndGoesOnWhereItStood) {
  LyingSensors lying;
  FaultSettings settings;
  settings.stuck_encoder = 1.0;
  lying.tell(settings, kCounterBits, reading(100, 100, 0.1, 0.1));
  OdometryReading told = lying.tell(settings, kCounterBits, reading(200, 200, 0.2, 0.2));
  EXPECT_EQ(told.ticks.left, 100);
  EXPECT_EQ(told.left_distance, 0.1);
  EXPECT_EQ(told.ticks.right, 200);
  told = lying.tell(FaultSettings{}, kCounterBits, reading(250, 250, 0.25, 0.25));
  EXPECT_EQ(told.ticks.left, 150);
  EXPECT_NEAR(told.left_distance, 0.15, 1e-12);
}

TEST(LyingSensors, AReversedEncoderCountsBackwardsAroundTheCountersEnd) {
  LyingSensors lying;
  FaultSettings settings;
  settings.reversed_encoder = 2.0;
  lying.tell(settings, kCounterBits, reading(0, 65530, 0.0, 0.1));
  const OdometryReading told = lying.tell(settings, kCounterBits, reading(0, 4, 0.0, 0.2));
  EXPECT_EQ(told.ticks.right, 65520);
  EXPECT_NEAR(told.right_distance, 0.0, 1e-12);
  EXPECT_EQ(told.ticks.left, 0);
}

}  // namespace
}  // namespace markservo::simulator
