// Whatever the bus says, what is kept of it is bounded, and the robot's own troubles are told all the same.

#include <gtest/gtest.h>

#include <algorithm>

#include "services/mmi/troubles/known.hpp"
#include "tests/unit/mmi/healthy_robot.hpp"

namespace markservo::mmi {
namespace {

struct Entry {
  double heard = 0.0;
};

TEST(Known, KeepsAHundredAndForgetsOnlyWhoIsQuiet) {
  std::map<int, Entry> all;
  for (int i = 0; i < 1000; ++i) {
    if (Entry* entry = known_or_new(all, i, 1.0)) entry->heard = 1.0;
  }
  EXPECT_EQ(all.size(), kMostKnown);
  EXPECT_NE(known_or_new(all, 5, 2.0), nullptr);
  EXPECT_EQ(known_or_new(all, 2000, 2.0), nullptr);
  all[5].heard = 20.0;
  EXPECT_NE(known_or_new(all, 2000, 20.0), nullptr);
  EXPECT_EQ(all.size(), kMostKnown);
  EXPECT_EQ(all.count(5), 1U);
}

void invent(HealthyRobot& robot, int i) {
  const std::string name = "invented_" + std::to_string(i);
  const std::int64_t at = robot.at();
  const double now = robot.now;
  ServiceWord service = HealthyRobot::service(name, 1000 + i);
  service.state = "stale";
  service.reason = name + ": all refused: utime is 9 s ahead of this host's clock";
  service.channels = {{name, 1, 1000, 0, true}};
  robot.watch.observe(service, now);
  ProcessWord process = HealthyRobot::process(name, 1000 + i);
  process.state = ProcessState::kFailed;
  robot.watch.observe(process, now);
  robot.watch.observe(RecorderWord{at, name, name, false, 0, 0, 0, "why"}, now);
  robot.watch.observe(StopWord{at, name, true, true, "why"}, now);
  robot.watch.observe(MarksWord{at, {{name, true, MarkStatus::kUnseen}}}, now);
  robot.say("STOP_STATE", 1000 + i, 9'000'000, true, name);
  robot.say("JOINT_STATE", 1000 + i, 9'000'000, true);
}

TEST(TroubleWatch, StaysSmallAndFindsTheRobotsOwnTroubleAmongAThousandInventedNames) {
  HealthyRobot robot;
  robot.pass(5.0);
  int invented = 0;
  robot.each_tick = [&] {
    for (int i = 0; i < 100; ++i) invent(robot, invented++);
  };
  std::vector<Trouble> troubles = robot.pass(3.0);
  EXPECT_LE(troubles.size(), 500U);
  robot.silent = {"arm"};
  troubles = robot.pass(5.0);
  ASSERT_FALSE(troubles.empty());
  EXPECT_EQ(troubles.front().code, TroubleCode::kStopDeviceSilent);
  EXPECT_EQ(troubles.front().subject, "arm");
}

TEST(TroubleWatch, HasOneStopWhereDeviceAfterDeviceLatches) {
  HealthyRobot robot;
  robot.pass(5.0);
  robot.stops[0].latched = true;
  robot.pass(0.2);
  robot.stops[1].latched = true;
  const std::vector<Trouble> troubles = robot.pass(0.4);
  ASSERT_EQ(troubles.size(), 1U);
  EXPECT_EQ(troubles[0].subject, "arm, base");
  EXPECT_EQ(identity_of(troubles[0]), identity_of({TroubleCode::kStopLatched, "arm", 0, "", ""}));
}

}  // namespace
}  // namespace markservo::mmi
