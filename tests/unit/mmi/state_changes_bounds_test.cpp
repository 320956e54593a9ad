// What is remembered stays bounded, whatever names and numbers are invented.

#include <gtest/gtest.h>

#include <string>

#include "services/mmi/scene/request_memory.hpp"
#include "services/mmi/scene/state_changes.hpp"

namespace markservo::mmi {
namespace {

constexpr std::int64_t kSecond = 1'000'000;  // us

ServiceReport service(const std::string& name, const std::string& state = "ready") {
  return {1, name, "robot", state, ""};
}

TEST(BoundsOfStateChanges, WhoSpeaksIsNotForgottenForInventedNames) {
  StateChanges::Parameters parameters;
  parameters.writers_max = 3;
  StateChanges changes(parameters);
  EXPECT_TRUE(changes.observe(service("honest"), 0, 0.0));
  for (int i = 0; i < 100; ++i) {
    changes.observe(service("invented" + std::to_string(i)), i * kSecond / 10, 0.1 * i);
    EXPECT_FALSE(changes.observe(service("honest"), i * kSecond / 10, 0.1 * i)) << "it is no newcomer";
  }
  EXPECT_EQ(changes.untold(), 98);
  EXPECT_TRUE(changes.observe(service("honest", "stale"), 10 * kSecond, 10.0));
}

TEST(BoundsOfStateChanges, AnotherKindIsNotConcerned) {
  StateChanges::Parameters parameters;
  parameters.writers_max = 3;
  StateChanges changes(parameters);
  for (int i = 0; i < 100; ++i) changes.observe(service("invented" + std::to_string(i)), 0, 0.0);
  EXPECT_TRUE(changes.observe(TaskReport{1, TaskPhase::kIdle, 0, "", ""}, 0, 0.0));
  EXPECT_TRUE(changes.observe(StopReport{1, "arm", true, 0, 0, ""}, 0, 0.0));
}

TEST(BoundsOfStateChanges, WhoWasQuietForLongMakesRoom) {
  StateChanges::Parameters parameters;
  parameters.writers_max = 2;
  StateChanges changes(parameters);
  changes.observe(service("gone"), 0, 0.0);
  changes.observe(service("here"), 9 * kSecond, 9.0);
  EXPECT_FALSE(changes.observe(service("new"), 9 * kSecond, 9.0));
  EXPECT_TRUE(changes.observe(service("new"), 11 * kSecond, 11.0));
  EXPECT_FALSE(changes.observe(service("here"), 11 * kSecond, 11.0)) << "it was remembered";
}

TEST(BoundsOfStateChanges, RequestsAreForgottenOldestFirst) {
  RequestMemory memory(2);
  EXPECT_TRUE(memory.is_new("STOP", 1, 1));
  EXPECT_TRUE(memory.is_new("STOP", 1, 2));
  EXPECT_FALSE(memory.is_new("STOP", 1, 1));
  EXPECT_TRUE(memory.is_new("TASK_COMMAND", 1, 1));
  EXPECT_FALSE(memory.is_new("STOP", 1, 2));
  EXPECT_TRUE(memory.is_new("STOP", 1, 1)) << "forgotten for the third";
}

TEST(StateChanges, TellsFiftyRequestsASecondAndCountsTheRest) {
  StateChanges changes;
  int told = 0;
  for (int i = 0; i < 3000; ++i) {
    StopRequestReport request;
    request.session = 7;
    request.request_id = i + 1;
    if (changes.observe(request, 0, i < 2000 ? 0.5 : 2.0)) ++told;
  }
  EXPECT_EQ(told, 100);
  EXPECT_EQ(changes.untold(), 2900);
}

TEST(StateChanges, MakesRoomByAClockThatDoesNotGoBack) {
  StateChanges::Parameters parameters;
  parameters.writers_max = 1;
  StateChanges changes(parameters);
  changes.observe(service("gone"), 3600 * kSecond, 0.0);
  EXPECT_TRUE(changes.observe(service("new"), 0, 11.0)) << "whatever the wall clock was set to";
}

}  // namespace
}  // namespace markservo::mmi
