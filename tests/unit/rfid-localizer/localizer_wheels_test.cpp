// Wheels that are worse than stated: what the localiser believes of them, and what it says.

#include <gtest/gtest.h>

#include <cmath>

#include "common/geometry/degrees.hpp"
#include "services/rfid-localizer/robot_parameters.hpp"
#include "tests/unit/rfid-localizer/drive.hpp"

namespace markservo::rfid_localizer {
namespace {

using namespace test;

DriveSettings in_the_hall(int seed, double drift_deg, double pivot_wander) {
  DriveSettings settings;
  settings.seed = static_cast<std::uint64_t>(seed);
  settings.localizer = parameters_of(settings.robot);
  settings.rig.tag_field = "hall";
  settings.rig.base.drift = geometry::radians(drift_deg);
  settings.rig.base.pivot_wander = pivot_wander;
  settings.start = {2.0, 2.0, 0.0};
  return settings;
}

// To and fro in the hall's middle, a turn of about 90 degrees after each way; steered by the truth.
void legs(Drive& drive, int count) {
  for (int leg = 0; leg < count; ++leg) {
    drive.go(6.0, 0.25, 0.0);
    drive.stand(0.6);
    // Back to where tags are all around, but by no turn of always the same angle.
    const geometry::PlanePose pose = drive.now().truth.pose;
    const double back = std::atan2(2.0 - pose.y, 2.0 - pose.x) + (leg % 2 == 0 ? 0.4 : -0.4);
    double missing = geometry::wrapped(back - pose.heading);
    while (std::abs(missing) > 0.02) {
      drive.go(0.1, 0.0, std::copysign(std::min(1.5, 4.0 * std::abs(missing)), missing));
      missing = geometry::wrapped(back - drive.now().truth.pose.heading);
    }
    drive.stand(0.6);
  }
}

double mean_nees(const std::vector<Scored>& scores) {
  double sum = 0.0;
  for (const Scored& one : scores) sum += one.nees();
  return sum / static_cast<double>(scores.size());
}

TEST(LocalizerWheels, WorseThanStatedAreToldAndBelievedLess) {
  double nees = 0.0;
  double unjudged_nees = 0.0;
  constexpr int kSeeds = 3;
  for (int seed = 1; seed <= kSeeds; ++seed) {
    DriveSettings settings = in_the_hall(seed, 8.0, 0.02);
    Drive drive(settings);
    legs(drive, 40);
    const WheelJudgement wheels = drive.localizer().wheel_judgement();
    EXPECT_TRUE(wheels.drift.too_small) << seed;
    EXPECT_TRUE(wheels.pivot_wander.too_small) << seed;
    EXPECT_NEAR(geometry::degrees(wheels.drift.stated), 2.0, 1e-9);
    EXPECT_NEAR(geometry::degrees(wheels.drift.fits), 8.0, 0.4 * 8.0) << seed;
    EXPECT_NEAR(wheels.pivot_wander.fits, 0.02, 0.4 * 0.02) << seed;
    nees += mean_nees(drive.since(120.0)) / kSeeds;
    settings.localizer.judge.reset();
    Drive unjudged(settings);
    legs(unjudged, 40);
    unjudged_nees += mean_nees(unjudged.since(120.0)) / kSeeds;
  }
  EXPECT_GT(nees, 1.5);
  EXPECT_LT(nees, 5.0);
  EXPECT_GT(unjudged_nees, 2.0 * nees);
}

TEST(LocalizerWheels, AsStatedAreBelievedAsBefore) {
  for (int seed = 1; seed <= 3; ++seed) {
    DriveSettings settings = in_the_hall(seed, 2.0, 0.0);
    Drive drive(settings);
    settings.localizer.judge.reset();
    Drive before(settings);
    for (Drive* one : {&drive, &before}) legs(*one, 15);
    EXPECT_FALSE(drive.localizer().wheel_judgement().drift.too_small) << seed;
    EXPECT_FALSE(drive.localizer().wheel_judgement().pivot_wander.too_small) << seed;
    EXPECT_EQ(drive.now().estimate.pose.pose, before.now().estimate.pose.pose) << seed;
    EXPECT_EQ(drive.now().estimate.pose.covariance, before.now().estimate.pose.covariance) << seed;
  }
}

TEST(LocalizerWheels, ARobotThatIsCarriedAwayIsNoFaultOfItsWheels) {
  Drive drive(in_the_hall(2, 2.0, 0.0));
  legs(drive, 4);
  for (int i = 0; i < 3; ++i) {
    const geometry::PlanePose pose = drive.now().truth.pose;
    drive.carry_to({4.0 - pose.x, pose.y, pose.heading + 1.0});
    drive.stand(4.0);
    legs(drive, 2);
  }
  EXPECT_FALSE(drive.localizer().wheel_judgement().drift.too_small);
  EXPECT_LT(drive.localizer().wheel_judgement().pivot_wander.fits, 0.01);
}

TEST(LocalizerWheels, WithoutEncodersNothingIsJudged) {
  DriveSettings settings = in_the_hall(1, 8.0, 0.02);
  settings.encoders = false;
  Drive drive(settings);
  legs(drive, 5);
  EXPECT_FALSE(drive.localizer().wheel_judgement().drift.too_small);
  EXPECT_FALSE(drive.localizer().wheel_judgement().pivot_wander.too_small);
}

}  // namespace
}  // namespace markservo::rfid_localizer
