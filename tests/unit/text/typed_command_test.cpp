#include "common/text/typed_command.hpp"

#include <gtest/gtest.h>

namespace markservo::text {
namespace {

TEST(TypedCommand, IsTheOneThatAScriptPassesOn) {
  const TypedCommand in_a_checkout("scripts/task");
  EXPECT_EQ(in_a_checkout.name_or("task-operator"), "task");
  EXPECT_EQ(in_a_checkout.call_or("task-operator"), "scripts/task");
  const TypedCommand installed("markservo print-mark");
  EXPECT_EQ(installed.name_or("simulator"), "print-mark");
  EXPECT_EQ(installed.call_or("simulator"), "markservo print-mark");
}

TEST(TypedCommand, OfAProgramThatWasStartedByItsPathIsItsOwn) {
  for (const char* path :
       {"build/release/bin/log-tool", "log-tool", "", "/srv/scripts/log", "scripts/", "scripts/a b"}) {
    EXPECT_EQ(TypedCommand(path).name_or("log-tool"), "log-tool") << path;
    EXPECT_EQ(TypedCommand(path).call_or("log-tool"), "log-tool") << path;
  }
}

TEST(TypedCommand, KnowsHowTheOthersAreTyped) {
  EXPECT_EQ(TypedCommand("scripts/replay").of("log"), "scripts/log");
  EXPECT_EQ(TypedCommand("markservo replay").of("log"), "markservo log");
  EXPECT_EQ(TypedCommand("build/release/bin/log-tool").of("log"), "scripts/log");
}

}  // namespace
}  // namespace markservo::text
