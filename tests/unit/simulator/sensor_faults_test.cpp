#include "services/simulator/faults/sensor_faults.hpp"

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

TEST(SensorFaults, AreNoneByDefault) {
  SensorFaults faults;
  ArmReading arm;
  arm.position = {0.1, 0.2, 0.3};
  EXPECT_EQ(faults.apply(FaultSettings{}, arm).position, arm.position);
  const OdometryReading told = faults.apply(FaultSettings{}, kCounterBits, reading(65535, 7, 1.0, 2.0));
  EXPECT_EQ(told.ticks.left, 65535);
  EXPECT_EQ(told.right_distance, 2.0);
  EXPECT_EQ(faults.apply(FaultSettings{}, picture(9)).left.at<cv::Vec3b>(0, 0)[0], 9);
}

TEST(SensorFaults, AFrozenJointStaysWhereItStoodUntilItIsMended) {
  SensorFaults faults;
  FaultSettings settings;
  settings.frozen_joint = 2.0;
  ArmReading arm;
  arm.position = {0.1, 0.2, 0.3};
  EXPECT_EQ(faults.apply(settings, arm).position[1], 0.2);
  arm.position = {0.4, 0.5, 0.6};
  arm.speed = {1.0, 1.0, 1.0};
  const ArmReading told = faults.apply(settings, arm);
  EXPECT_EQ(told.position, robot::JointVector(0.4, 0.2, 0.6));
  EXPECT_EQ(told.speed[1], 0.0);
  EXPECT_EQ(told.speed[0], 1.0);
  EXPECT_EQ(faults.apply(FaultSettings{}, arm).position[1], 0.5);
}

TEST(SensorFaults, AFrozenCameraShowsWhatItSaw) {
  SensorFaults faults;
  FaultSettings settings;
  settings.frozen_camera = 1.0;
  faults.apply(settings, picture(10));
  EXPECT_EQ(faults.apply(settings, picture(20)).right.at<cv::Vec3b>(1, 1)[2], 10);
  EXPECT_EQ(faults.apply(FaultSettings{}, picture(30)).right.at<cv::Vec3b>(1, 1)[2], 30);
}

TEST(SensorFaults, AStuckEncoderDoesNotCountAndGoesOnWhereItStood) {
  SensorFaults faults;
  FaultSettings settings;
  settings.stuck_encoder = 1.0;
  faults.apply(settings, kCounterBits, reading(100, 100, 0.1, 0.1));
  OdometryReading told = faults.apply(settings, kCounterBits, reading(200, 200, 0.2, 0.2));
  EXPECT_EQ(told.ticks.left, 100);
  EXPECT_EQ(told.left_distance, 0.1);
  EXPECT_EQ(told.ticks.right, 200);
  told = faults.apply(FaultSettings{}, kCounterBits, reading(250, 250, 0.25, 0.25));
  EXPECT_EQ(told.ticks.left, 150);
  EXPECT_NEAR(told.left_distance, 0.15, 1e-12);
}

TEST(SensorFaults, AReversedEncoderCountsBackwardsAroundTheCountersEnd) {
  SensorFaults faults;
  FaultSettings settings;
  settings.reversed_encoder = 2.0;
  faults.apply(settings, kCounterBits, reading(0, 65530, 0.0, 0.1));
  const OdometryReading told = faults.apply(settings, kCounterBits, reading(0, 4, 0.0, 0.2));
  EXPECT_EQ(told.ticks.right, 65520);
  EXPECT_NEAR(told.right_distance, 0.0, 1e-12);
  EXPECT_EQ(told.ticks.left, 0);
}

}  // namespace
}  // namespace markservo::simulator
