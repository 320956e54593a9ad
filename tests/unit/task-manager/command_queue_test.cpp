// What waits for the next step: each command once, and none that is no longer repeated.

#include "services/task-manager/command_queue.hpp"

#include <gtest/gtest.h>

namespace markservo::task_manager {
namespace {

constexpr CommandQueue::Time milliseconds(CommandQueue::Time count) {
  return 1000 * count;
}

constexpr CommandQueue::Time kStart{};

Command command(CommandKind kind, std::int64_t id) {
  Command result;
  result.session = 42;
  result.id = id;
  result.kind = kind;
  return result;
}

TEST(CommandQueue, HandsOverEachCommandOnceInOrder) {
  CommandQueue queue;
  for (int i = 0; i < 1000; ++i) {
    queue.add(command(CommandKind::kStart, 1), kStart);
    queue.add(command(CommandKind::kAbort, 2), kStart);
  }
  const auto commands = queue.take(kStart, true);
  ASSERT_EQ(commands.size(), 2u);
  EXPECT_EQ(commands[0].id, 1);
  EXPECT_EQ(commands[1].id, 2);
  EXPECT_TRUE(queue.take(kStart, true).empty());
}

TEST(CommandQueue, AStartThatIsNoLongerRepeatedIsForgotten) {
  CommandQueue queue;
  queue.add(command(CommandKind::kStart, 1), kStart);
  queue.add(command(CommandKind::kHome, 2), kStart);
  EXPECT_TRUE(queue.take(kStart + milliseconds(1600), true).empty());
}

TEST(CommandQueue, AStartThatIsStillRepeatedIsExecutedHoweverLongItWaited) {
  CommandQueue queue;
  for (int ms = 0; ms <= 10'000; ms += 200) queue.add(command(CommandKind::kStart, 1), kStart + milliseconds(ms));
  EXPECT_EQ(queue.take(kStart + milliseconds(10'800), true).size(), 1u);
}

TEST(CommandQueue, AnAbortNeverAges) {
  CommandQueue queue;
  queue.add(command(CommandKind::kAbort, 1), kStart);
  EXPECT_EQ(queue.take(kStart + milliseconds(3'600'000), true).size(), 1u);
}

TEST(CommandQueue, InALogNothingAges) {
  CommandQueue queue;
  queue.add(command(CommandKind::kStart, 1), kStart);
  EXPECT_EQ(queue.take(kStart + milliseconds(3'600'000), false).size(), 1u);
}

TEST(CommandQueue, StaysSmallAndKeepsTheAbort) {
  CommandQueue queue;
  queue.add(command(CommandKind::kAbort, 1), kStart);
  for (std::int64_t id = 2; id < 1000; ++id) queue.add(command(CommandKind::kStart, id), kStart);
  EXPECT_EQ(queue.size(), CommandQueue::kMost);
  const auto commands = queue.take(kStart, true);
  EXPECT_EQ(commands.front().kind, CommandKind::kAbort);
  EXPECT_EQ(commands.back().id, 999);
}

}  // namespace
}  // namespace markservo::task_manager
