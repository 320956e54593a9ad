#include "services/simulator/arm/servo_model.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace markservo::simulator {
namespace {

constexpr double kStep_s = 0.002;
constexpr double kArrived = 1e-8;  // rad

ServoParameters ideal() {
  ServoParameters parameters;
  parameters.speed = 5.0;
  return parameters;
}

void wait(ServoModel& servo, const ServoParameters& parameters, double seconds) {
  for (double t = 0.0; t < seconds; t += kStep_s) servo.step(parameters, kStep_s);
}

TEST(ServoModel, AnIdealServoArrivesExactlyAndStops) {
  ServoModel servo(0.1);
  servo.command(0.3, 10.0);
  wait(servo, ideal(), 0.2);
  EXPECT_EQ(servo.shaft(), 0.3);
  EXPECT_FALSE(servo.moving());
  EXPECT_EQ(servo.shaft_speed(), 0.0);
}

TEST(ServoModel, MovesNoFasterThanItsCommandAllows) {
  ServoModel servo(0.0);
  servo.command(-1.0, 0.5);
  wait(servo, ideal(), 1.0);
  EXPECT_NEAR(servo.shaft(), -0.5, 0.5 * 2 * kStep_s);
  EXPECT_NEAR(servo.shaft_speed(), -0.5, 1e-9);
}

TEST(ServoModel, MovesNoFasterThanItself) {
  ServoModel servo(0.0);
  servo.command(10.0, 1000.0);
  wait(servo, ideal(), 1.0);
  const double run_up = 0.5 * 5.0 * 5.0 / ideal().acceleration;
  EXPECT_NEAR(servo.shaft(), 5.0 - run_up, 5.0 * 2 * kStep_s);
}

TEST(ServoModel, GathersSpeedAndBrakesNoHarderThanItsMotorCan) {
  for (const DeadbandKind kind : {DeadbandKind::kStopsAtEdge, DeadbandKind::kRunsHome}) {
    ServoParameters parameters = ideal();
    parameters.deadband = 0.005;
    parameters.deadband_kind = kind;
    ServoModel servo(0.0);
    const double most = parameters.acceleration * kStep_s * (1.0 + 1e-9);
    double speed = 0.0;
    double highest = 0.0;
    for (int step = 0; step < 1000; ++step) {
      if (step == 0) servo.command(0.3, 100.0);
      if (step == 500) servo.command(0.2, 0.5);
      servo.step(parameters, kStep_s);
      EXPECT_LE(std::abs(servo.shaft_speed() - speed), most) << "in step " << step;
      speed = servo.shaft_speed();
      highest = std::max(highest, servo.shaft());
    }
    const double goal = kind == DeadbandKind::kRunsHome ? 0.3 : 0.3 - parameters.deadband;
    EXPECT_LE(highest, goal + kArrived) << "it does not overshoot";
    EXPECT_LT(servo.shaft(), 0.25) << "it came back";
    EXPECT_EQ(speed, 0.0);
  }
}

TEST(ServoModel, FreezesWhereItIs) {
  ServoModel servo(0.0);
  servo.command(1.0, 1.0);
  wait(servo, ideal(), 0.5);
  servo.freeze();
  const double there = servo.ramp();
  wait(servo, ideal(), 0.5);
  EXPECT_EQ(servo.shaft(), there);
  EXPECT_NEAR(there, 0.5, 0.01);
}

TEST(ServoModel, StopsAtTheDeadbandsEdgeFromEitherSide) {
  ServoParameters parameters = ideal();
  parameters.deadband = 0.01;
  ServoModel servo(0.0);
  servo.command(0.2, 5.0);
  wait(servo, parameters, 0.5);
  EXPECT_NEAR(servo.shaft(), 0.19, kArrived);
  servo.command(-0.2, 5.0);
  wait(servo, parameters, 0.5);
  EXPECT_NEAR(servo.shaft(), -0.19, kArrived);
}

TEST(ServoModel, IgnoresCommandsInsideTheDeadband) {
  for (const DeadbandKind kind : {DeadbandKind::kStopsAtEdge, DeadbandKind::kRunsHome}) {
    ServoParameters parameters = ideal();
    parameters.deadband = 0.01;
    parameters.deadband_kind = kind;
    ServoModel servo(0.0);
    servo.command(0.009, 5.0);
    wait(servo, parameters, 0.5);
    EXPECT_EQ(servo.shaft(), 0.0);
    EXPECT_EQ(servo.ramp(), 0.009);
  }
}

TEST(ServoModel, RunsHomeOnceItHasStarted) {
  ServoParameters parameters = ideal();
  parameters.deadband = 0.01;
  parameters.deadband_kind = DeadbandKind::kRunsHome;
  ServoModel servo(0.0);
  servo.command(0.012, 50.0);
  wait(servo, parameters, 0.5);
  EXPECT_EQ(servo.shaft(), 0.012);
}

TEST(ServoModel, BacklashIsTakenUpBeforeTheShaftTurnsBack) {
  ServoParameters parameters = ideal();
  parameters.backlash = 0.02;
  ServoModel servo(0.0);
  servo.command(0.1, 5.0);
  wait(servo, parameters, 0.5);
  EXPECT_NEAR(servo.shaft(), 0.09, kArrived);
  servo.command(0.085, 5.0);
  wait(servo, parameters, 0.5);
  EXPECT_NEAR(servo.shaft(), 0.09, kArrived) << "within the play nothing turns";
  servo.command(0.05, 5.0);
  wait(servo, parameters, 0.5);
  EXPECT_NEAR(servo.shaft(), 0.06, kArrived);
}

}  // namespace
}  // namespace markservo::simulator
