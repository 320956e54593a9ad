#include "services/stack-watch/silence.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>

namespace markservo::stack_watch {
namespace {

constexpr std::int64_t kSecond_us = 1'000'000;
constexpr std::int64_t kTick_us = 250'000;
constexpr std::int64_t kSession = 11;
constexpr std::int64_t kBegin_us = 100 * kSecond_us;

// A stack of two services on a bus, by the quarter of a second.
class Stack {
 public:
  // What speaks, and whether own words come back, in the next `seconds`.
  struct Phase {
    double seconds = 0.0;
    bool servo = true;
    bool locator = true;
    bool bus = true;
  };

  void run(const Phase& phase) {
    const auto ticks = static_cast<int>(phase.seconds * kSecond_us / kTick_us);
    for (int i = 0; i < ticks; ++i, now_us += kTick_us, ++count) {
      if (count % 4 == 0) {
        watch.send_beacon();
        if (phase.bus && phase.servo) watch.observe_word("visual-servo", 7, kSession, now_us);
        if (phase.bus && phase.locator) watch.observe_word("target-locator", 8, kSession + 1, now_us);
        if (phase.bus) watch.observe_beacon(now_us);
      }
      for (const SilentService& silent : watch.step(processes, now_us)) told.push_back(silent);
    }
  }

  SilenceWatch watch;
  std::vector<RunningProcess> processes{{"visual-servo", 7}, {"target-locator", 8}};
  std::vector<SilentService> told;
  std::int64_t now_us = kBegin_us;
  int count = 0;
};

TEST(SilenceWatch, TellsOfOneThatSpokeAndThenIsSilentForFiveSeconds) {
  Stack stack;
  stack.run({30});
  EXPECT_TRUE(stack.told.empty());
  stack.run({5.75, false});
  ASSERT_EQ(stack.told.size(), 1U);
  EXPECT_EQ(stack.told[0].name, "visual-servo");
  EXPECT_EQ(stack.told[0].pid, 7);
  EXPECT_NEAR(1e-6 * static_cast<double>(stack.told[0].silent_us), 5.0, 0.5);
}

TEST(SilenceWatch, SaysNothingBeforeFiveSeconds) {
  Stack stack;
  stack.run({30});
  stack.run({3.75, false});  // the last word was up to 1 s earlier
  stack.run({30});
  EXPECT_TRUE(stack.told.empty());
}

TEST(SilenceWatch, WaitsForOneThatNeedNotSpeak) {
  Stack stack;
  stack.run({60, false});
  EXPECT_TRUE(stack.told.empty());
}

TEST(SilenceWatch, TellsOfOneThatHasSaidNothingFifteenSecondsAfterItMust) {
  Stack stack;
  stack.run({30, false});  // what makes it wait before it begins
  stack.processes[0].must_speak = true;
  stack.run({14.5, false});
  EXPECT_TRUE(stack.told.empty());
  stack.run({1, false});
  ASSERT_EQ(stack.told.size(), 1U);
  EXPECT_EQ(stack.told[0].name, "visual-servo");
  EXPECT_FALSE(stack.told[0].spoke);
  EXPECT_NEAR(1e-6 * static_cast<double>(stack.told[0].silent_us), 15.0, 0.5);
}

// Processes 100 to 119 of the name, each for 100 s, that must speak and do not.
int told_of_mute(Stack* stack) {
  stack->told.clear();
  for (int pid = 100; pid < 120; ++pid) {
    stack->processes = {{"visual-servo", pid, true}, {"target-locator", 8}};
    stack->run({100, false});
  }
  return static_cast<int>(stack->told.size());
}

TEST(SilenceWatch, GivesUpOnANameThatNeverSpeaksHere) {
  Stack stack;
  EXPECT_EQ(told_of_mute(&stack), 3) << "it may speak on another bus";
}

TEST(SilenceWatch, GivesANameThatSpokeHereTwiceAsLongAfterEachInVain) {
  Stack stack;
  stack.run({30});
  std::vector<double> silent;
  for (int pid = 100; silent.size() < 6; ++pid) {
    stack.processes = {{"visual-servo", pid, true}, {"target-locator", 8}};
    stack.told.clear();
    while (stack.told.empty()) stack.run({1, false});
    silent.push_back(std::round(1e-6 * static_cast<double>(stack.told.front().silent_us)));
  }
  EXPECT_EQ(silent, (std::vector<double>{15, 30, 60, 120, 240, 240}));
}

TEST(SilenceWatch, ListensToNobodyElse) {
  Stack stack;
  stack.run({30});
  for (int i = 0; i < 12; ++i) {
    stack.watch.observe_word("visual-servo", 70, kSession + 7, stack.now_us);
    stack.watch.observe_session(kSession + 7, stack.now_us);
    for (int pid = 1000; pid < 4000; ++pid) stack.watch.observe_word("x", pid, pid, stack.now_us);
    stack.run({0.5, false});
  }
  ASSERT_EQ(stack.told.size(), 1U) << "a word of another process of that name is none of its own";
  EXPECT_EQ(stack.told[0].pid, 7);
  EXPECT_TRUE(stack.told[0].spoke);
}

TEST(SilenceWatch, LeavesOneAloneThatTheSupervisorDoesNotRun) {
  Stack stack;
  stack.run({30});
  stack.processes = {{"target-locator", 8}};
  stack.run({30, false});
  EXPECT_TRUE(stack.told.empty());
}

TEST(SilenceWatch, LeavesTheNextProcessOfThatNameAloneUntilItMustSpeak) {
  Stack stack;
  stack.run({30});
  stack.processes = {{"visual-servo", 9}, {"target-locator", 8}};
  stack.run({30, false});
  EXPECT_TRUE(stack.told.empty());
}

TEST(SilenceWatch, TakesAnyMessageOfItsSessionForASignOfLife) {
  Stack stack;
  stack.run({30});
  for (int i = 0; i < 20; ++i) {
    stack.run({1, false});
    stack.watch.observe_session(kSession, stack.now_us);
  }
  EXPECT_TRUE(stack.told.empty());
}

TEST(SilenceWatch, TellsOfNobodyWhileTheBusIsGoneAndCountsAnewWhenItIsBack) {
  Stack stack;
  stack.run({30});
  stack.run({60, true, true, false});
  EXPECT_TRUE(stack.watch.bus_is_gone());
  stack.run({9, false, true});  // 5 s to come back, and then 5 s
  EXPECT_TRUE(stack.told.empty());
  EXPECT_FALSE(stack.watch.bus_is_gone());
  stack.run({5, false, true});
  ASSERT_EQ(stack.told.size(), 1U);
  EXPECT_EQ(stack.told[0].name, "visual-servo");
}

TEST(SilenceWatch, CountsAnewAfterItWasHeldUpItself) {
  Stack stack;
  stack.run({30});
  stack.run({3, false});
  stack.now_us += 60 * kSecond_us;
  stack.run({4, false});
  EXPECT_TRUE(stack.told.empty());
}

TEST(SilenceWatch, TellsAgainWhenWhatWasDoneDidNotHelp) {
  Stack stack;
  stack.run({30});
  stack.run({11, false});
  EXPECT_EQ(stack.told.size(), 2U);
}

TEST(SilenceWatch, WaitsLongerWhereHalfOfAllMessagesAreLost) {
  Stack stack;
  for (int i = 0; i < 20; ++i) {
    stack.run({1});
    stack.run({1, true, true, false});
  }
  EXPECT_TRUE(stack.told.empty());
  EXPECT_NEAR(1e-6 * static_cast<double>(stack.watch.limit_us()), 20.0, 3.0);
  stack.run({30});
  EXPECT_EQ(stack.watch.limit_us(), 5 * kSecond_us);
}

TEST(SilenceWatch, KeepsNoMoreThanTheProcessesThatRun) {
  Stack stack;
  for (int i = 0; i < 100'000; ++i) stack.watch.observe_word("x" + std::to_string(i), i, i + 1, stack.now_us);
  stack.run({30});
  EXPECT_EQ(stack.watch.silent_for_us("x5", 5, stack.now_us), -1);
  EXPECT_LE(stack.watch.silent_for_us("visual-servo", 7, stack.now_us), kSecond_us);
}

}  // namespace
}  // namespace markservo::stack_watch
