#include "tests/experiments/wander/pivot_drive.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "tests/experiments/localisation/field_box.hpp"

namespace markservo::experiments {
namespace {

robot::RobotDescription the_robot() {
  return robot::load_robot_description(std::string(MARKSERVO_SOURCE_DIR) + "/config/robot.yaml");
}

simulator::BaseRigParameters worse_wheels() {
  simulator::BaseRigParameters rig;
  rig.tag_field = "hall";
  rig.base.drift = geometry::radians(8.0);
  rig.base.pivot_wander = 0.02;
  return rig;
}

PivotDrive six_pivots() {
  PivotDrive course;
  course.pivots = 6;
  return course;
}

// The headings at which it ended its pivots: those it has just before the next leg begins.
TEST(PivotDrive, TurnsByNinetyDegreesAtTheEndOfEachLeg) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const PivotDrive course = six_pivots();
    const Drive drive = drive_with_pivots(the_robot(), worse_wheels(), course, seed);
    const TruePath path(drive.truth);
    EXPECT_NEAR(drive.truth.back().time, 90.0, 0.03);
    double before = 0.0;
    for (int leg = 1; leg <= course.pivots; ++leg) {
      const double heading = path.at(leg * course.leg_time - 0.05).heading;
      EXPECT_NEAR(std::abs(heading - before), M_PI / 2.0, 0.03) << "seed " << seed << ", leg " << leg;
      before = heading;
    }
    EXPECT_GT(drive.truth.back().turned, course.pivots * 1.4);
  }
}

TEST(PivotDrive, StaysOnTheFieldAndDrivesFarOnIt) {
  const robot::RobotDescription robot = the_robot();
  const FieldBox box = field_box(robot.floor_tags->field("hall"));
  const Drive drive = drive_with_pivots(robot, worse_wheels(), six_pivots(), 3);
  for (const PathPoint& point : drive.truth) ASSERT_TRUE(box.contains(point.p_WR, -0.1)) << point.time << " s";
  EXPECT_GT(drive.truth.back().wheel_travel, 6 * 1.8);
}

TEST(PivotDrive, ASeedGivesTheSameDrive) {
  const Drive one = drive_with_pivots(the_robot(), worse_wheels(), six_pivots(), 7);
  const Drive same = drive_with_pivots(the_robot(), worse_wheels(), six_pivots(), 7);
  const Drive other = drive_with_pivots(the_robot(), worse_wheels(), six_pivots(), 8);
  EXPECT_EQ(one.truth.back().p_WR, same.truth.back().p_WR);
  EXPECT_NE(one.truth.back().p_WR, other.truth.back().p_WR);
}

}  // namespace
}  // namespace markservo::experiments
