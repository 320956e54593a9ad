#include "services/base-navigator/kinematics/course.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "services/base-navigator/drive/leg_plan.hpp"

namespace markservo::base_navigator {
namespace {

using geometry::PlanePose;

const CourseParameters kCourse;

PlanePose end_of(const PlanePose& X_GR, Direction direction) {
  const auto path = course_path(kCourse, X_GR, direction, 0.01, 20.0);
  return X_GR * path.back().X_RS;
}

TEST(Course, IsStraightOnTheGoalsAxis) {
  const Course course = steer(kCourse, {-1.0, 0.0, 0.0}, Direction::kForward);
  EXPECT_NEAR(course.curvature, 0.0, 1e-12);
  EXPECT_NEAR(course.remaining, 1.0, 1e-12);
}

TEST(Course, BendsTowardsTheAxis) {
  EXPECT_GT(steer(kCourse, {-1.0, -0.1, 0.0}, Direction::kForward).curvature, 0.1);
  EXPECT_LT(steer(kCourse, {-1.0, 0.1, 0.0}, Direction::kForward).curvature, -0.1);
  EXPECT_LT(steer(kCourse, {-1.0, 0.0, 0.1}, Direction::kForward).curvature, -0.1);
}

TEST(Course, ArrivesFromAnySideWithTheGoalsHeading) {
  for (double bearing = -0.75; bearing <= 0.75; bearing += 0.25) {
    for (double heading = -0.6; heading <= 0.6; heading += 0.3) {
      const PlanePose start{-1.5 * std::cos(bearing), 1.5 * std::sin(bearing), heading};
      const PlanePose end = end_of(start, Direction::kForward);
      EXPECT_NEAR(end.x, 0.0, 0.01) << bearing << ' ' << heading;
      EXPECT_NEAR(end.y, 0.0, 0.012) << bearing << ' ' << heading;
      EXPECT_NEAR(end.heading, 0.0, 0.05) << bearing << ' ' << heading;
    }
  }
}

TEST(Course, BackwardIsTheMirrorImageOfForward) {
  const PlanePose forward{-0.8, 0.1, 0.2};
  const PlanePose backward{0.8, -0.1, 0.2};
  const Course ahead = steer(kCourse, forward, Direction::kForward);
  const Course back = steer(kCourse, backward, Direction::kBackward);
  EXPECT_DOUBLE_EQ(ahead.curvature, back.curvature);
  EXPECT_DOUBLE_EQ(ahead.remaining, back.remaining);
  const PlanePose end = end_of(backward, Direction::kBackward);
  EXPECT_NEAR(end.distance(), 0.0, 0.015);
  EXPECT_NEAR(end.heading, 0.0, 0.05);
}

TEST(Course, ACentimetreBesideTheGoalMakesNoSharpBend) {
  EXPECT_LT(std::abs(steer(kCourse, {-0.01, 0.01, 0.0}, Direction::kForward).curvature), 2.0);
}

TEST(LegPlan, GoesStraightToADockAheadAndTurnsAtAnOpenGoalThatLooksElsewhere) {
  const LegParameters legs;
  const LegPlan dock = plan_leg(legs, {}, {1.0, 0.1, 0.0}, true, false, 1.0, 1.0);
  EXPECT_TRUE(dock.leg.to_goal);
  EXPECT_NEAR(dock.leg.X_WV.heading, 0.0, 1e-12);
  const LegPlan open = plan_leg(legs, {}, {1.0, 0.0, M_PI / 2.0}, false, false, 1.0, 1.0);
  EXPECT_TRUE(open.leg.to_goal);
  EXPECT_NEAR(open.leg.X_WV.heading, 0.0, 1e-12);
}

TEST(LegPlan, EntersADockThatLooksElsewhereFromAPointBeforeIt) {
  const LegPlan plan = plan_leg(LegParameters(), {}, {1.0, 0.0, M_PI / 2.0}, true, false, 1.0, 1.0);
  EXPECT_FALSE(plan.leg.to_goal);
  EXPECT_NEAR(plan.leg.X_WV.x, 1.0, 1e-9);
  EXPECT_NEAR(plan.leg.X_WV.y, -0.5, 1e-9);
}

TEST(LegPlan, ReversesToAGoalJustBehindAndTurnsForOneFarBehind) {
  EXPECT_EQ(plan_leg(LegParameters(), {}, {-0.3, 0.05, 0.0}, false, false, 1.0, 1.0).leg.direction,
            Direction::kBackward);
  EXPECT_EQ(plan_leg(LegParameters(), {}, {-2.0, 0.05, 0.0}, false, false, 1.0, 1.0).leg.direction,
            Direction::kForward);
}

TEST(LegPlan, BacksOffToWhereThereIsRoomWhenItStandsBesideTheGoal) {
  const PlanePose goal{0.0, 0.03, 0.0};
  const LegPlan back = plan_leg(LegParameters(), {}, goal, true, false, 0.45, 0.02);
  EXPECT_EQ(back.leg.direction, Direction::kBackward);
  EXPECT_FALSE(back.leg.to_goal);
  EXPECT_LT(back.leg.X_WV.x, -0.2);
  const LegPlan ahead = plan_leg(LegParameters(), {}, goal, true, false, 0.02, 0.45);
  EXPECT_EQ(ahead.leg.direction, Direction::kForward);
  EXPECT_GT(ahead.leg.X_WV.x, 0.2);
  // Nowhere: the best it can do is the last centimetres.
  EXPECT_TRUE(plan_leg(LegParameters(), {}, goal, true, false, 0.02, 0.02).leg.to_goal);
}

}  // namespace
}  // namespace markservo::base_navigator
