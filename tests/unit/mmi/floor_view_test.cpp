#include "services/mmi/scene/floor_view.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "common/robot/configuration_error.hpp"

namespace markservo::mmi {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::int64_t kNow = 100'000'000;  // us
constexpr double kDelay = 0.2;              // s

// Tags A at 0, B at 0.10 and C at 0.20 m along x, and FAR away from them; a reader of 0.12 m before R's origin.
robot::RobotDescription robot_with_tags() {
  robot::RobotDescription robot;
  robot.rfid.emplace();
  robot.rfid->p_RF = {0.05, 0.0};
  robot.rfid->reading_radius = 0.12;
  robot.rfid->edge_softness = 0.01;
  robot.rfid->delay = 5.0;  // not the one that is estimated
  robot.floor_tags.emplace();
  robot.floor_tags->in_use = "line";
  robot.floor_tags->fields = {
      {"line", {{"A", {0.0, 0.0}}, {"B", {0.10, 0.0}}, {"C", {0.20, 0.0}}, {"FAR", {3.0, 0.0}}}},
      {"other", {{"X", {0.0, 0.0}}}}};
  return robot;
}

class FloorOfTags : public ::testing::Test {
 protected:
  // The robot's pose at `time`, s before kNow.
  void stand(double before, double x, double y, double heading) {
    PoseReport pose;
    pose.utime = kNow - std::llround(1e6 * before);
    pose.session = 1;
    pose.state = LocalisationState::kLocalised;
    pose.X_WR = {x, y, heading};
    pose.delay = kDelay;
    floor_.observe(pose);
  }
  Json read(const std::vector<std::string>& uids) {
    RoundReport round;
    round.utime = kNow;
    for (const std::string& uid : uids) round.hits.push_back({uid, kNow - 7, std::nullopt});
    floor_.observe(round);
    return floor_.json();
  }

  robot::RobotDescription robot_ = robot_with_tags();
  FloorView floor_{robot_, ""};
};

TEST_F(FloorOfTags, NothingIsToldBeforeTheFirstRound) {
  stand(0.2, 0.0, 0.0, 0.0);
  EXPECT_TRUE(floor_.json().is_null());
  EXPECT_EQ(floor_.version(), 0u);
}

TEST_F(FloorOfTags, ExpectedAreTheTagsWithinTheAntennasReachWhereTheRobotWasAtTheReading) {
  stand(0.2, 0.0, 0.0, 0.0);
  stand(0.0, 3.0, 0.0, 0.0);  // where it is now
  const Json json = read({"A"});
  EXPECT_EQ(json["expected"], Json({"A", "B"}));  // the antenna is at 0.05 m
  EXPECT_EQ(json["missed"], Json({"B"}));
  EXPECT_EQ(json["unexpected"], Json::array());
  EXPECT_EQ(json["utime"], std::to_string(kNow));
  EXPECT_EQ(json["pose"], Json({0.0, 0.0, 0.0}));
}

TEST_F(FloorOfTags, TheAntennaTurnsWithTheRobot) {
  stand(0.2, 0.10, 0.0, M_PI);
  EXPECT_EQ(read({})["expected"], Json({"A", "B"}));
  stand(0.2, 0.10, 0.0, 0.0);
  EXPECT_EQ(read({})["expected"], Json({"B", "C"}));
}

TEST_F(FloorOfTags, ThePoseIsThatBetweenTheOnesAround) {
  stand(0.25, 2.80, 0.0, 0.0);
  stand(0.15, 3.0, 0.0, 0.0);  // at the reading 2.90, the antenna 2.95
  EXPECT_EQ(read({})["expected"], Json({"FAR"}));
  EXPECT_NEAR(floor_.json()["pose"][0].get<double>(), 2.90, 1e-9);
}

TEST_F(FloorOfTags, ATagAtTheRadiusIsExpectedAndOneBeyondIsNot) {
  robot_.floor_tags->fields[0].tags = {{"AT", {0.125, 0.0}}, {"BEYOND", {0.126, 0.0}}};
  robot_.rfid->p_RF = {0.0, 0.0};
  robot_.rfid->reading_radius = 0.125;
  floor_ = FloorView(robot_, "");
  stand(0.2, 0.0, 0.0, 0.0);
  EXPECT_EQ(read({})["expected"], Json({"AT"}));
}

TEST_F(FloorOfTags, ASurpriseIsReadFarBeyondTheRadiusOrOnNoMap) {
  // The antenna is at 0.05 m: of B 0.05, of C 0.15 m, within the edge of 5 * 0.01 m.
  stand(0.2, 0.0, 0.0, 0.0);
  EXPECT_EQ(read({"B", "C", "FAR", "E0"})["unexpected"], Json({"FAR", "E0"}));
  stand(0.2, -0.03, 0.0, 0.0);  // C is 0.18 m away
  EXPECT_EQ(read({"C"})["unexpected"], Json({"C"}));
}

TEST_F(FloorOfTags, WithoutAPoseNothingIsExpectedAndTheMapsTagsAreNoSurprise) {
  const Json json = read({"FAR", "E0"});
  EXPECT_EQ(json["expected"], Json::array());
  EXPECT_EQ(json["missed"], Json::array());
  EXPECT_EQ(json["unexpected"], Json({"E0"}));
  EXPECT_TRUE(json["pose"].is_null());
}

TEST_F(FloorOfTags, ATagReadIsToldWithItsPlaceItsStrengthAndTheRoundsThatHadIt) {
  read({"A"});
  RoundReport round;
  round.utime = kNow;
  round.hits = {{"A", 12, -40.5}, {"A", 13, -60.0}, {"E0", 14, std::nullopt}};
  floor_.observe(round);
  const Json tags = floor_.json()["read"];
  ASSERT_EQ(tags.size(), 2u) << "each once";
  EXPECT_EQ(tags[0], Json({{"uid", "A"}, {"rssi", -40.5}, {"at", "12"}, {"count", 2}, {"place", {0.0, 0.0}}}));
  EXPECT_EQ(tags[1], Json({{"uid", "E0"}, {"rssi", nullptr}, {"at", "14"}, {"count", 1}, {"place", nullptr}}));
}

TEST_F(FloorOfTags, TheUidsThatAreCountedAreBounded) {
  FloorView::Parameters parameters;
  parameters.tags_max = 2;
  floor_ = FloorView(robot_, "", parameters);
  read({"A", "E1", "E2"});
  const Json json = read({"A", "E1", "E2"});
  EXPECT_EQ(json["read"][1]["count"], 2);
  EXPECT_EQ(json["read"][2]["count"], 1);
}

TEST_F(FloorOfTags, AnotherFieldIsTakenByItsNameAndAnUnknownOneRefused) {
  floor_ = FloorView(robot_, "other");
  stand(0.2, 0.0, 0.0, 0.0);
  EXPECT_EQ(read({})["expected"], Json({"X"}));
  EXPECT_THROW(FloorView(robot_, "nowhere"), ConfigurationError);
}

TEST_F(FloorOfTags, ARobotWithoutReaderAndTagsShowsWhatIsRead) {
  floor_ = FloorView(robot::RobotDescription{}, "");
  stand(0.2, 0.0, 0.0, 0.0);
  const Json json = read({"A"});
  EXPECT_EQ(json["expected"], Json::array());
  EXPECT_EQ(json["read"][0]["uid"], "A");
}

}  // namespace
}  // namespace markservo::mmi
