#include "tests/experiments/localisation/course.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <set>

#include "common/robot/configuration_error.hpp"
#include "tests/experiments/localisation/field_box.hpp"

namespace markservo::experiments {
namespace {

const std::string kRobotFile = MARKSERVO_SOURCE_DIR "/config/robot.yaml";

const robot::RobotDescription& robot_description() {
  static const robot::RobotDescription robot = robot::load_robot_description(kRobotFile);
  return robot;
}

struct Driven {
  CoursePlan plan;
  Drive drive;
  FieldBox box;
};

Driven driven(const LocalisationCase& the_case, std::uint64_t seed = 3) {
  const robot::TagField& field = robot_description().floor_tags->field(the_case.rig.tag_field);
  const CoursePlan plan = plan_course(the_case, field, seed);
  return {plan, drive(robot_description(), the_case.rig, plan, seed), field_box(field)};
}

// m, the way of the samples within the field
double way_over_field(const Driven& run) {
  double way = 0.0;
  for (std::size_t i = 1; i < run.drive.truth.size(); ++i) {
    const PathPoint& point = run.drive.truth[i];
    if (run.box.contains(point.p_WR, 0.0)) way += (point.p_WR - run.drive.truth[i - 1].p_WR).norm();
  }
  return way;
}

// The greatest distance (m) of the true way from the line of the plan's start.
double off_the_line(const Driven& run) {
  const double heading = run.plan.start.heading;
  const Eigen::Vector2d across(-std::sin(heading), std::cos(heading));
  double most = 0.0;
  for (const PathPoint& point : run.drive.truth) {
    most = std::max(most, std::abs(across.dot(point.p_WR - Eigen::Vector2d(run.plan.start.x, run.plan.start.y))));
  }
  return most;
}

TEST(Course, GoesStraightOverThePapersFieldAtFullSpeedFromItsBeginToItsEnd) {
  const Driven run = driven(find_case("straight"));
  EXPECT_NEAR(way_over_field(run), 1.10, 0.03);
  EXPECT_LT(off_the_line(run), 0.01);
  int samples = 0;
  for (const PathPoint& point : run.drive.truth) {
    if (point.p_WR.y() < 0.0) continue;
    EXPECT_NEAR(point.speed, 0.40, 0.12);  // the wheels' noise comes in stretches of 2 cm
    EXPECT_NEAR(point.p_WR.x(), 0.20, 0.06);
    ++samples;
  }
  EXPECT_NEAR(samples * 0.02, 1.10 / 0.40, 0.1);
}

TEST(Course, CrossesTheFieldAt45Degrees) {
  const Driven run = driven(find_case("diagonal"));
  EXPECT_NEAR(way_over_field(run), 0.40 * std::sqrt(2.0), 0.03);
  EXPECT_LT(off_the_line(run), 0.01);
}

TEST(Course, StandsTwoSecondsBeforeItStarts) {
  const Driven run = driven(find_case("straight_standing"));
  for (const PathPoint& point : run.drive.truth) {
    if (point.time <= 2.0) {
      EXPECT_EQ(point.speed, 0.0);
    }
  }
  EXPECT_NEAR(way_over_field(run), 1.10, 0.03);
}

TEST(Course, CoversFourMetresOfTheHallAtAnyHeading) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const Driven run = driven(find_case("hall"), seed);
    EXPECT_NEAR(way_over_field(run), 4.0, 0.1);
    EXPECT_LT(off_the_line(run), 0.02);
  }
}

TEST(Course, HoldsItsCircle) {
  const Driven run = driven(find_case("circle"));
  const Eigen::Vector2d start(run.plan.start.x, run.plan.start.y);
  const double heading = run.plan.start.heading;
  const Eigen::Vector2d centre = start + 0.8 * Eigen::Vector2d(-std::sin(heading), std::cos(heading));
  for (const PathPoint& point : run.drive.truth) EXPECT_NEAR((point.p_WR - centre).norm(), 0.8, 0.02);
  EXPECT_GT(way_over_field(run), 2.0 * M_PI * 0.8 * 0.95);
}

TEST(Course, ChangesItsSpeedSixTimesWhenItStopsAndGoes) {
  const Driven run = driven(find_case("stop_and_go"));
  EXPECT_EQ(run.plan.speeds.size(), 6U);
  for (std::size_t i = 0; i < run.plan.speeds.size(); ++i) {
    const double end = i + 1 < run.plan.speeds.size() ? run.plan.speeds[i + 1].time : run.plan.duration;
    for (const PathPoint& point : run.drive.truth) {
      if (std::abs(point.time - end + 0.1) > 0.011) continue;
      EXPECT_NEAR(point.speed, run.plan.speeds[i].speed, 0.04);
    }
  }
  EXPECT_TRUE(run.box.contains(run.drive.truth.back().p_WR, 0.0));
}

TEST(Course, IsTheSameForTheSameSeedAndAnotherForAnother) {
  const Driven a = driven(find_case("hall"), 1);
  const Driven b = driven(find_case("hall"), 1);
  const Driven c = driven(find_case("hall"), 2);
  EXPECT_EQ(a.drive.truth.back().p_WR, b.drive.truth.back().p_WR);
  EXPECT_NE(a.drive.truth.back().p_WR, c.drive.truth.back().p_WR);
}

TEST(Cases, HaveNamesOfTheirOwnAndTheHallBeforeItsStresses) {
  std::set<std::string> names;
  bool hall = false;
  for (const LocalisationCase& the_case : localisation_cases()) {
    EXPECT_TRUE(names.insert(the_case.name).second) << the_case.name;
    EXPECT_EQ(the_case.name.find_first_of(" /?&"), std::string::npos) << "a name is part of file names and URLs";
    if (the_case.bars.hall_ratio) {
      EXPECT_TRUE(hall) << the_case.name;
    }
    hall = hall || the_case.name == "hall";
  }
}

TEST(Cases, ListTheNamesWhenOneIsUnknown) {
  try {
    find_case("moon");
    FAIL();
  } catch (const ConfigurationError& error) {
    EXPECT_NE(std::string(error.what()).find("straight, straight_standing"), std::string::npos) << error.what();
  }
}

TEST(RobotVariant, ChangesWhatItSaysAndNothingElse) {
  const std::string file = testing::TempDir() + "robot_variant.yaml";
  RobotVariant variant;
  variant.spacing = 0.34;
  variant.reading_radius = 0.20;
  variant.round_time = 0.05;
  variant.scale_sigma = 0.005;
  std::ofstream(file) << robot_text(kRobotFile, variant);
  const robot::RobotDescription changed = robot::load_robot_description(file);
  EXPECT_EQ(changed.rfid->reading_radius, 0.20);
  EXPECT_EQ(changed.rfid->round_time, 0.05);
  EXPECT_EQ(changed.base->scale_sigma, 0.005);
  EXPECT_EQ(changed.rfid->edge_softness, robot_description().rfid->edge_softness);
  EXPECT_EQ(changed.base->track, robot_description().base->track);
  const FieldBox hall = field_box(changed.floor_tags->field("hall"));
  EXPECT_EQ(changed.floor_tags->field("hall").tags.size(), 13U * 13U);
  EXPECT_NEAR(hall.size().x(), 4.08, 1e-9);
  EXPECT_EQ(changed.floor_tags->field("course").tags.size(), 5U * 12U);
  EXPECT_EQ(changed.floor_tags->field("course").tags[7].uid,
            robot_description().floor_tags->field("course").tags[7].uid);
  std::filesystem::remove(file);
}

TEST(RobotVariant, RefusesARobotWithoutAReader) {
  const std::string file = testing::TempDir() + "robot_without_reader.yaml";
  std::ofstream(file) << "cameras: {}\n";
  EXPECT_THROW(robot_text(file, RobotVariant{}), ConfigurationError);
  EXPECT_THROW(robot_text(file + ".missing", RobotVariant{}), ConfigurationError);
  std::filesystem::remove(file);
}

}  // namespace
}  // namespace markservo::experiments
