// The sections of robot.yaml that a robot which drives has.

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "common/robot/configuration_error.hpp"
#include "common/robot/robot_description.hpp"
#include "tests/unit/robot/robot_file.hpp"

namespace markservo::robot {
namespace {

constexpr char kFirstField[] = "    - name: course ";

class BaseSections : public RobotFile {
 protected:
  // The file with one more field of tags, as its lines below "- name: NAME" say.
  void add_field(const std::string& name, const std::string& lines) {
    change(kFirstField, "    - name: " + name + "\n      " + lines + "\n" + kFirstField);
  }

  // Whether the refusal of the file with `to` in place of `from` names `key`.
  void expect_refused(const std::string& from, const std::string& to, const std::string& key) {
    const std::string whole = text_;
    change(from, to);
    const std::string why = refusal();
    EXPECT_NE(why.find(key), std::string::npos) << to << ": " << why;
    text_ = whole;
  }
};

TEST_F(BaseSections, OfTheProjectAreAccepted) {
  const RobotDescription robot = load();
  ASSERT_TRUE(robot.base && robot.sonars && robot.rfid && robot.floor_tags);
  EXPECT_NEAR(robot.base->metres_per_tick(), 2.0 * M_PI * 0.0825 / 4096.0, 1e-12);
  EXPECT_NEAR(robot.base->turn_rate_max, M_PI, 1e-12);
  EXPECT_NEAR(robot.sonars->pose(0).heading, 0.0, 1e-12);
  EXPECT_NEAR(robot.sonars->pose(4).heading, M_PI / 2.0, 1e-12) << "to the left";
  EXPECT_NEAR(robot.rfid->delay, 0.19, 1e-12);
}

TEST_F(BaseSections, AWanderThatIsNotStatedIsNone) {
  EXPECT_EQ(load().base->pivot_wander, 0.0);
  change("pivot_wander: 0.0", "pivot_wander: 0.02");
  EXPECT_EQ(load().base->pivot_wander, 0.02);
  change(", pivot_wander: 0.02", "");
  EXPECT_EQ(load().base->pivot_wander, 0.0);
}

TEST_F(BaseSections, MayAllBeAbsent) {
  text_ = text_.substr(0, text_.find("# The mobile base")) + "stop_devices: [arm]\n";
  const RobotDescription robot = load();
  EXPECT_FALSE(robot.base || robot.sonars || robot.rfid || robot.floor_tags);
}

TEST_F(BaseSections, AGridCountsItsTagsAlongXThenY) {
  add_field("grid", "grid: {columns: 3, rows: 2, spacing: 0.25, first_uid: e00401500000FFFE}");
  const TagField field = load().floor_tags->field("grid");
  const std::vector<std::pair<std::string, Eigen::Vector2d>> expected = {
      {"E00401500000FFFE", {0.0, 0.0}},  {"E00401500000FFFF", {0.25, 0.0}},  {"E004015000010000", {0.5, 0.0}},
      {"E004015000010001", {0.0, 0.25}}, {"E004015000010002", {0.25, 0.25}}, {"E004015000010003", {0.5, 0.25}}};
  ASSERT_EQ(field.tags.size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    EXPECT_EQ(field.tags[i].uid, expected[i].first);
    EXPECT_LT((field.tags[i].p_W - expected[i].second).norm(), 1e-12) << i;
  }
}

TEST_F(BaseSections, AListGivesEachTagsPlaceAndItsUidInUpperCase) {
  add_field("list", "tags: [{uid: e0a1, position: [0.5, -1.25]}, {uid: E0A2, position: [3.0, 4.0]}]");
  const TagField field = load().floor_tags->field("list");
  ASSERT_EQ(field.tags.size(), 2U);
  EXPECT_EQ(field.tags[0].uid, "E0A1");
  EXPECT_EQ(field.tags[0].p_W, Eigen::Vector2d(0.5, -1.25));
}

TEST_F(BaseSections, AFieldIsFoundByItsNameOrIsTheOneInUse) {
  const FloorTagsDescription floor = *load().floor_tags;
  EXPECT_EQ(floor.field("").name, "course");
  EXPECT_EQ(floor.field("hall").tags.size(), 41U * 41U);
  try {
    floor.field("cellar");
    FAIL();
  } catch (const ConfigurationError& error) {
    EXPECT_NE(std::string(error.what()).find("'cellar'"), std::string::npos);
    EXPECT_NE(std::string(error.what()).find("course, hall"), std::string::npos) << error.what();
  }
}

TEST_F(BaseSections, WithAUidTwiceAreRefused) {
  add_field("list", "tags: [{uid: E0A1, position: [0.5, 0.0]}, {uid: e0a1, position: [3.0, 4.0]}]");
  EXPECT_NE(refusal().find("'E0A1' twice"), std::string::npos);
}

TEST_F(BaseSections, WithATagWithoutPositionOrOfTooFewNumbersAreRefused) {
  add_field("list", "tags: [{uid: E0A1}]");
  EXPECT_NE(refusal().find("position' is missing"), std::string::npos);
  expect_refused("{uid: E0A1}", "{uid: E0A1, position: [0.1]}", "position");
  expect_refused("{uid: E0A1}", "{uid: E0A1, position: [0.1, .nan]}", "position");
  expect_refused("{uid: E0A1}", "{uid: E0A1, position: [0.1, 5000.0]}", "position");
}

TEST_F(BaseSections, WithAUidThatIsNoneAreRefused) {
  add_field("list", "tags: [{uid: E0A1, position: [0.5, 0.0]}]");
  expect_refused("uid: E0A1", "uid: E0G1", "'E0G1'");
  expect_refused("uid: E0A1", "uid: \"\"", "uid");
  expect_refused("uid: E0A1", "uid: E00000000000000000000000000000001", "uid");
  expect_refused("first_uid: E004015000001000", "first_uid: E0401", "first_uid");
}

TEST_F(BaseSections, WithoutTagsInAFieldOrWithTooManyAreRefused) {
  add_field("list", "tags: []");
  EXPECT_NE(refusal().find("tags"), std::string::npos);
  expect_refused("tags: []", "grid: {columns: 1000, rows: 101, spacing: 0.1, first_uid: E004015000001000}", "rows");
  expect_refused("tags: []", "grid: {columns: 0, rows: 5, spacing: 0.1, first_uid: E004015000001000}", "columns");
}

TEST_F(BaseSections, WithAFieldInUseThatIsNotThereOrANameTwiceAreRefused) {
  expect_refused("in_use: course", "in_use: cellar", "'cellar'");
  expect_refused("- name: hall", "- name: course", "'course' twice");
}

TEST_F(BaseSections, WithAnImpossibleReaderAreRefused) {
  expect_refused("reading_radius: 0.10", "reading_radius: 0.0", "reading_radius");
  expect_refused("edge_softness: 0.01", "edge_softness: -0.01", "edge_softness");
  expect_refused("read_probability: 0.95", "read_probability: 1.0", "read_probability");
  expect_refused("  delay: 0.19", "  delay: late", "delay");
}

TEST_F(BaseSections, WithAnImpossibleBaseAreRefused) {
  expect_refused("wheel_radius: 0.0825", "wheel_radius: 0.0", "wheel_radius");
  expect_refused("ticks_per_turn: 4096", "ticks_per_turn: 0", "ticks_per_turn");
  expect_refused("counter_bits: 16", "counter_bits: 33", "counter_bits");
  expect_refused("track: 0.32", "track: 0.32\n  trak: 0.32", "base.trak");
  expect_refused("pivot_wander: 0.0", "pivot_wander: -0.01", "base.odometry.pivot_wander");
  expect_refused("pivot_wander: 0.0", "pivot_wander: 2.0", "base.odometry.pivot_wander");
  expect_refused("pivot_wander: 0.0", "pivot_wander: wide", "base.odometry.pivot_wander");
  expect_refused("range: [0.10, 5.0]", "range: [5.0, 0.10]", "range");
}

}  // namespace
}  // namespace markservo::robot
