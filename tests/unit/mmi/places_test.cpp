#include "services/mmi/scene/places.hpp"

#include <gtest/gtest.h>

#include "services/mmi/scene/camera_pose.hpp"

namespace markservo::mmi {
namespace {

using Json = nlohmann::ordered_json;

class PlacesOfMarks : public ::testing::Test {
 protected:
  static MarkReport book(MarkStatus status = MarkStatus::kLocated) {
    MarkReport mark;
    mark.name = "red_book";
    mark.status = status;
    mark.cue = MarkCue::kTexture;
    mark.p_C = {0.05, 0.30, -0.10};
    mark.covariance_C << 1.0, 2.0, 3.0,  //
        2.0, 4.0, 5.0,                   //
        3.0, 5.0, 6.0;
    mark.normal_C = {0.0, -1.0, 0.0};
    return mark;
  }

  robot::RobotDescription robot_ = [] {
    robot::RobotDescription robot;
    robot.cameras.p_RC = {0.10, 0.03, 0.70};
    return robot;
  }();
  Places places_{robot_};
};

TEST_F(PlacesOfMarks, NothingIsToldBeforeTheFirstTargetPose) {
  places_.observe(ServoGoalReport{true, "red_book", {0.0, 0.0, 0.0}});
  EXPECT_TRUE(places_.json().is_null());
}

TEST_F(PlacesOfMarks, AMarkIsTurnedIntoTheRobotsFrame) {
  places_.observe(TargetReport{77, 8, {book()}});
  const Json json = places_.json();
  EXPECT_EQ(json["utime"], "77");
  EXPECT_EQ(json["frame_seq"], "8");
  const Json mark = json["marks"][0];
  EXPECT_EQ(mark["name"], "red_book");
  EXPECT_EQ(mark["role"], "target");
  EXPECT_EQ(mark["status"], "LOCATED");
  EXPECT_EQ(mark["cue"], "CUE_TEXTURE");
  EXPECT_NEAR(mark["p_R"][0].get<double>(), 0.40, 1e-12);
  EXPECT_NEAR(mark["p_R"][1].get<double>(), -0.02, 1e-12);
  EXPECT_NEAR(mark["p_R"][2].get<double>(), 0.60, 1e-12);
  // R's x is C's y, R's y is minus C's x.
  EXPECT_EQ(mark["covariance_R"], Json({4.0, -2.0, 5.0, 1.0, -3.0, 6.0}));
  EXPECT_EQ(mark["normal_R"], Json({-1.0, 0.0, 0.0}));
}

TEST_F(PlacesOfMarks, AMarkThatIsNotLocatedHasNoPlace) {
  places_.observe(TargetReport{77, 8, {book(MarkStatus::kUnseen)}});
  const Json mark = places_.json()["marks"][0];
  EXPECT_EQ(mark["status"], "UNSEEN");
  EXPECT_TRUE(mark["p_R"].is_null());
  EXPECT_TRUE(mark["covariance_R"].is_null());
  EXPECT_TRUE(mark["normal_R"].is_null());
}

TEST_F(PlacesOfMarks, WhatNoPlaneCarriesHasNoNormal) {
  MarkReport mark = book();
  mark.normal_C.setZero();
  places_.observe(TargetReport{77, 8, {mark}});
  EXPECT_TRUE(places_.json()["marks"][0]["normal_R"].is_null());
  EXPECT_FALSE(places_.json()["marks"][0]["p_R"].is_null());
}

TEST_F(PlacesOfMarks, TheGripGoalIsTheTargetAndWhatTheGoalAdds) {
  places_.observe(TargetReport{77, 8, {book()}});
  EXPECT_TRUE(places_.json()["grip_goal_R"].is_null());
  places_.observe(ServoGoalReport{true, "red_book", {0.0, 0.015, -0.052}});
  const Eigen::Vector3d expected = camera_pose(robot_.cameras) * Eigen::Vector3d(0.05, 0.315, -0.152);
  ASSERT_TRUE(places_.grip_goal());
  EXPECT_TRUE(places_.grip_goal()->isApprox(expected, 1e-12));
  EXPECT_EQ(places_.json()["grip_goal_R"][0], places_.grip_goal()->x());
}

TEST_F(PlacesOfMarks, ThereIsNoGripGoalOfAnUnseenOrUnknownTargetNorOfAnotherGoal) {
  places_.observe(TargetReport{77, 8, {book()}});
  places_.observe(ServoGoalReport{true, "blue_book", {0.0, 0.0, 0.0}});
  EXPECT_FALSE(places_.grip_goal());
  places_.observe(ServoGoalReport{false, "red_book", {0.0, 0.0, 0.0}});
  EXPECT_FALSE(places_.grip_goal());
  places_.observe(ServoGoalReport{true, "red_book", {0.0, 0.0, 0.0}});
  EXPECT_TRUE(places_.grip_goal());
  places_.observe(TargetReport{78, 9, {book(MarkStatus::kClipped)}});
  EXPECT_FALSE(places_.grip_goal());
}

TEST_F(PlacesOfMarks, TheVersionGrowsWithWhatConcernsIt) {
  places_.observe(TargetReport{77, 8, {book()}});
  places_.observe(BaseReport{});
  places_.observe(ServoGoalReport{});
  EXPECT_EQ(places_.version(), 2u);
}

}  // namespace
}  // namespace markservo::mmi
