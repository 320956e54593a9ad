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
  EXPECT_TRUE(changes.observe(service("honest"), 0));
  for (int i = 0; i < 100; ++i) {
    changes.observe(service("invented" + std::to_string(i)), i * kSecond / 10);
    EXPECT_FALSE(changes.observe(service("honest"), i * kSecond / 10)) << "it is no newcomer";
  }
  EXPECT_EQ(changes.untold(), 98);
  EXPECT_TRUE(changes.observe(service("honest", "stale"), 10 * kSecond));
}

TEST(BoundsOfStateChanges, AnotherKindIsNotConcerned) {
  StateChanges::Parameters parameters;
  parameters.writers_max = 3;
  StateChanges changes(parameters);
  for (int i = 0; i < 100; ++i) changes.observe(service("invented" + std::to_string(i)), 0);
  EXPECT_TRUE(changes.observe(TaskReport{1, TaskPhase::kIdle, 0, "", ""}, 0));
  EXPECT_TRUE(changes.observe(StopReport{1, "arm", true, 0, 0, ""}, 0));
}

TEST(BoundsOfStateChanges, WhoWasQuietForLongMakesRoom) {
  StateChanges::Parameters parameters;
  parameters.writers_max = 2;
  StateChanges changes(parameters);
  changes.observe(service("gone"), 0);
  changes.observe(service("here"), 9 * kSecond);
  EXPECT_FALSE(changes.observe(service("new"), 9 * kSecond));
  EXPECT_TRUE(changes.observe(service("new"), 11 * kSecond));
  EXPECT_FALSE(changes.observe(service("here"), 11 * kSecond)) << "it was remembered";
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

}  // namespace
}  // namespace markservo::mmi
