#include "services/simulator/readers/tag_floor.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>
#include <string>

namespace markservo::simulator {
namespace {

const robot::TagField& hall() {
  static const robot::RobotDescription robot =
      robot::load_robot_description(std::string(MARKSERVO_SOURCE_DIR) + "/config/robot.yaml");
  return robot.floor_tags->field("hall");
}

TEST(TagFloor, IsTheMapUnlessToldOtherwise) {
  const TagFloor floor(hall(), {}, 1);
  ASSERT_EQ(floor.tags().size(), hall().tags.size());
  for (std::size_t i = 0; i < hall().tags.size(); ++i) {
    EXPECT_EQ(floor.tags()[i].uid, hall().tags[i].uid);
    EXPECT_EQ(floor.tags()[i].p_W, hall().tags[i].p_W);
  }
}

TEST(TagFloor, FindsTheSameTagsNearAPointAsALookAtAllOfThem) {
  const TagFloor floor(hall(), {0.0, 0.05}, 2);
  for (const Eigen::Vector2d& p : {Eigen::Vector2d(1.23, 2.34), Eigen::Vector2d(-0.1, 0.02), Eigen::Vector2d(9.0, 9.0),
                                   Eigen::Vector2d(0.249, 0.251)}) {
    for (const double radius : {0.0, 0.07, 0.21, 0.9}) {
      std::vector<int> expected;
      for (std::size_t i = 0; i < floor.tags().size(); ++i) {
        if ((floor.tags()[i].p_W - p).norm() <= radius) expected.push_back(static_cast<int>(i));
      }
      EXPECT_EQ(floor.near(p, radius), expected) << p.transpose() << ", radius " << radius;
    }
  }
}

TEST(TagFloor, LacksItsShareOfTags) {
  const TagFloor floor(hall(), {0.1, 0.0}, 3);
  const auto all = static_cast<double>(hall().tags.size());
  EXPECT_NEAR(static_cast<double>(floor.tags().size()), 0.9 * all, 4.0 * std::sqrt(0.09 * all));
  EXPECT_TRUE(floor.maps(hall().tags.front().uid));
  for (const robot::FloorTag& tag : hall().tags) EXPECT_TRUE(floor.maps(tag.uid)) << "missing ones are mapped too";
  EXPECT_FALSE(floor.maps("00"));
}

TEST(TagFloor, TrueTagsLieOffTheirSurveyedPlaces) {
  const TagFloor floor(hall(), {0.0, 0.005}, 4);
  double squares = 0.0;
  double sum = 0.0;
  for (std::size_t i = 0; i < floor.tags().size(); ++i) {
    const Eigen::Vector2d error = floor.tags()[i].p_W - hall().tags[i].p_W;
    squares += error.squaredNorm();
    sum += error.sum();
  }
  const double n = 2.0 * static_cast<double>(floor.tags().size());
  EXPECT_NEAR(std::sqrt(squares / n), 0.005, 4.0 * 0.005 / std::sqrt(2.0 * n));
  EXPECT_NEAR(sum / n, 0.0, 4.0 * 0.005 / std::sqrt(n));
}

TEST(TagFloor, TheSeedDecidesWhichTagsAreMissing) {
  const auto first_of = [](std::uint64_t seed) {
    const TagFloor floor(hall(), {0.5, 0.0}, seed);
    std::string uids;
    for (const robot::FloorTag& tag : floor.tags()) uids += tag.uid;
    return uids;
  };
  EXPECT_EQ(first_of(1), first_of(1));
  EXPECT_NE(first_of(1), first_of(2));
}

TEST(TagFloor, RefusesParametersOutOfRange) {
  EXPECT_THROW(TagFloor(hall(), {1.5, 0.0}, 1), std::invalid_argument);
  EXPECT_THROW(TagFloor(hall(), {0.0, -0.001}, 1), std::invalid_argument);
}

}  // namespace
}  // namespace markservo::simulator
