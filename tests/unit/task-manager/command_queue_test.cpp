// What waits for the next step: each command once.

#include "services/task-manager/inputs/command_queue.hpp"

#include <gtest/gtest.h>

namespace markservo::task_manager {
namespace {

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
    queue.add(command(CommandKind::kStart, 1));
    queue.add(command(CommandKind::kAbort, 2));
  }
  const auto commands = queue.take();
  ASSERT_EQ(commands.size(), 2u);
  EXPECT_EQ(commands[0].id, 1);
  EXPECT_EQ(commands[1].id, 2);
  EXPECT_TRUE(queue.take().empty());
}

TEST(CommandQueue, ARepeatRenewsTheTimeOfWhatWaits) {
  CommandQueue queue;
  Command start = command(CommandKind::kStart, 1);
  start.utime = 1000;
  queue.add(start);
  start.utime = 1200;
  queue.add(start);
  const auto commands = queue.take();
  ASSERT_EQ(commands.size(), 1u);
  EXPECT_EQ(commands[0].utime, 1200);
}

TEST(CommandQueue, KeepsAnAbortUnderTheIdOfAStart) {
  CommandQueue queue;
  queue.add(command(CommandKind::kStart, 1));
  queue.add(command(CommandKind::kAbort, 1));
  const auto commands = queue.take();
  ASSERT_EQ(commands.size(), 2u);
  EXPECT_EQ(commands[0].kind, CommandKind::kStart);
  EXPECT_EQ(commands[1].kind, CommandKind::kAbort);
}

TEST(CommandQueue, StaysSmallAndKeepsTheAbort) {
  CommandQueue queue;
  queue.add(command(CommandKind::kAbort, 1));
  for (std::int64_t id = 2; id < 1000; ++id) queue.add(command(CommandKind::kStart, id));
  EXPECT_EQ(queue.size(), CommandQueue::kMost);
  const auto commands = queue.take();
  EXPECT_EQ(commands.front().kind, CommandKind::kAbort);
  EXPECT_EQ(commands.back().id, 999);
}

}  // namespace
}  // namespace markservo::task_manager
