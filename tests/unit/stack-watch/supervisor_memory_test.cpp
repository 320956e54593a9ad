#include "services/stack-watch/supervisor/supervisor_memory.hpp"

#include <gtest/gtest.h>

namespace markservo::stack_watch {
namespace {

using News = SupervisorMemory::News;

SupervisorAnswer alive_with(const std::string& name, int pid) {
  SupervisedProcess process;
  process.name = name;
  process.state = "RUNNING";
  process.pid = pid;
  SupervisorAnswer answer;
  answer.processes = {process};
  answer.running = {{name, pid, true}};
  answer.alive = true;
  return answer;
}

SupervisorAnswer silent(const std::string& why_not) {
  SupervisorAnswer answer;
  answer.why_not = why_not;
  return answer;
}

SupervisorAnswer not_asked(const std::string& why) {
  SupervisorAnswer answer;
  answer.cannot_ask = why;
  return answer;
}

TEST(SupervisorMemory, TellsItsEndOnceAndRemembersWhoRan) {
  SupervisorMemory memory;
  EXPECT_EQ(memory.observe(alive_with("visual-servo", 7), 100), News::kAnswers);
  EXPECT_EQ(memory.observe(silent("no such file"), 200), News::kDied);
  EXPECT_EQ(memory.observe(silent("no such file"), 300), News::kNone);
  EXPECT_TRUE(memory.is_dead());
  EXPECT_EQ(memory.changed_us(), 200);
  ASSERT_EQ(memory.running().size(), 1U);
  EXPECT_EQ(memory.running()[0].pid, 7);
  EXPECT_EQ(memory.processes().size(), 1U);
  EXPECT_EQ(memory.observe(alive_with("visual-servo", 8), 400), News::kAnswers);
  EXPECT_EQ(memory.running()[0].pid, 8);
}

TEST(SupervisorMemory, TakesOneThatNeverAnsweredForNoDeadOne) {
  SupervisorMemory memory;
  EXPECT_EQ(memory.observe(silent("no such file"), 100), News::kNone);
  EXPECT_FALSE(memory.is_dead());
  EXPECT_FALSE(memory.is_alive());
}

TEST(SupervisorMemory, HoldsToWhatItKnowsWhileItCannotAsk) {
  SupervisorMemory memory;
  memory.observe(alive_with("visual-servo", 7), 100);
  EXPECT_EQ(memory.observe(not_asked("too many open files"), 200), News::kCannotBeAsked);
  EXPECT_EQ(memory.observe(not_asked("too many open files"), 300), News::kNone);
  EXPECT_TRUE(memory.is_alive());
  EXPECT_EQ(memory.running().size(), 1U);
  EXPECT_EQ(memory.observe(alive_with("visual-servo", 7), 400), News::kNone);
  EXPECT_EQ(memory.cannot_ask(), "");
  EXPECT_EQ(memory.changed_us(), 100);
}

}  // namespace
}  // namespace markservo::stack_watch
