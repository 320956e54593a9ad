// The tables of command_inbox.hpp and stop_latch.hpp, walked through.

#include "common/motion/command_inbox.hpp"

#include <gtest/gtest.h>

#include "common/motion/stop_latch.hpp"

namespace markservo::motion {
namespace {

constexpr std::int64_t kNow = 1'000'000'000;

StopRequestStamp request(bool reset, std::int64_t id, std::int64_t utime = kNow) {
  return {{7, id, utime}, reset, reset ? "reset by a hand" : "stop by a hand"};
}

TEST(CommandInbox, ExecutesEachCommandOnce) {
  CommandInbox inbox("TASK_COMMAND", "JOINT_STATE");
  EXPECT_EQ(inbox.hear({7, 1, kNow}, kNow, false), CommandHeard::kExecute);
  EXPECT_EQ(inbox.hear({7, 1, kNow + 200'000}, kNow + 200'000, false), CommandHeard::kAgain);
  EXPECT_EQ(inbox.hear({7, 2, kNow}, kNow, false), CommandHeard::kExecute);
  EXPECT_EQ(inbox.hear({7, 1, kNow}, kNow, false), CommandHeard::kAgain) << "an older one that comes late";
  EXPECT_EQ(inbox.session(), 7);
  EXPECT_EQ(inbox.id(), 2);
}

TEST(CommandInbox, ExecutesNothingThatIsTwoSecondsOutOfTimeEitherWay) {
  CommandInbox inbox("TASK_COMMAND", "JOINT_STATE");
  EXPECT_EQ(inbox.hear({7, 1, kNow - 2'000'001}, kNow, false), CommandHeard::kStale);
  EXPECT_EQ(inbox.hear({7, 1, kNow + 2'000'001}, kNow, false), CommandHeard::kStale);
  EXPECT_EQ(inbox.hear({7, 1, 0}, kNow, false), CommandHeard::kStale);
  EXPECT_EQ(inbox.id(), 0) << "what is refused is not echoed";
  EXPECT_EQ(inbox.hear({7, 1, kNow}, kNow, false), CommandHeard::kExecute) << "and may come again, stamped anew";
}

TEST(CommandInbox, SaysHowFarOutOfTime) {
  const CommandInbox inbox("TASK_COMMAND", "JOINT_STATE");
  EXPECT_EQ(inbox.why_stale({7, 1, kNow - 2'280'000'000}, kNow),
            "TASK_COMMAND is 2280.00 s older than JOINT_STATE; allowed: 2.00 s");
}

TEST(CommandInbox, ObeysSomeWhateverTheirTime) {
  CommandInbox inbox("TASK_COMMAND", "JOINT_STATE");
  EXPECT_EQ(inbox.hear({7, 1, 0}, kNow, true), CommandHeard::kExecute);
}

TEST(StopLatch, ComesUpLatched) {
  const StopLatch latch("JOINT_STATE");
  EXPECT_TRUE(latch.latched());
  EXPECT_EQ(latch.reason(), "comes up stopped");
  EXPECT_EQ(latch.session(), 0);
}

TEST(StopLatch, AFreshResetReleasesAndAnyStopLatches) {
  StopLatch latch("JOINT_STATE");
  EXPECT_EQ(latch.hear(request(true, 1), kNow), StopHeard::kReleased);
  EXPECT_FALSE(latch.latched());
  EXPECT_EQ(latch.hear(request(false, 2, 0), kNow), StopHeard::kLatched) << "a STOP of any age";
  EXPECT_TRUE(latch.latched());
  EXPECT_EQ(latch.reason(), "stop by a hand");
  EXPECT_EQ(latch.id(), 2);
}

TEST(StopLatch, AnOldResetReleasesNothingAndIsNotEchoed) {
  StopLatch latch("JOINT_STATE");
  EXPECT_EQ(latch.hear(request(true, 1, kNow - 2'280'000'000), kNow), StopHeard::kStale);
  EXPECT_TRUE(latch.latched());
  EXPECT_EQ(latch.id(), 0);
}

TEST(StopLatch, ARepeatedResetDoesNotReleaseWhatWasStoppedSince) {
  StopLatch latch("JOINT_STATE");
  latch.hear(request(true, 1), kNow);
  latch.hear({{8, 1, kNow}, false, "another's stop"}, kNow);
  EXPECT_EQ(latch.hear(request(true, 1), kNow), StopHeard::kAgain);
  EXPECT_TRUE(latch.latched());
}

TEST(StopLatch, AnyStopLatchesThoughItsSenderCountsBadly) {
  StopLatch latch("JOINT_STATE");
  latch.hear(request(false, 1), kNow);
  latch.hear({{8, 1, kNow}, true, "another's reset"}, kNow);
  EXPECT_EQ(latch.hear(request(false, 1), kNow), StopHeard::kLatched) << "an id that it has used";
  latch.hear({{7, 1'000, kNow}, true, "its own reset"}, kNow);
  EXPECT_FALSE(latch.latched());
  EXPECT_EQ(latch.hear(request(false, 2), kNow), StopHeard::kLatched) << "an id below its last";
  EXPECT_EQ(latch.id(), 2) << "it is echoed";
  EXPECT_EQ(latch.hear(request(false, 2), kNow), StopHeard::kAgain) << "a repetition";
}

TEST(StopLatch, ANamelessStopMakesItForgetNoReset) {
  StopLatch latch("JOINT_STATE");
  latch.hear(request(true, 1), kNow);
  EXPECT_EQ(latch.hear(request(false, 0), kNow), StopHeard::kLatched);
  EXPECT_EQ(latch.hear(request(true, 1), kNow), StopHeard::kAgain);
  EXPECT_TRUE(latch.latched());
}

TEST(StopLatch, AResetReleasesNoStopThatIsYounger) {
  StopLatch latch("JOINT_STATE");
  latch.hear(request(true, 1), kNow);
  latch.hear({{8, 1, 0}, false, "another's stop"}, kNow + 1'000'000);
  const StopRequestStamp late = request(true, 2, kNow + 500'000);
  EXPECT_EQ(latch.hear(late, kNow + 1'100'000), StopHeard::kStale);
  EXPECT_EQ(latch.why_stale(late, kNow + 1'100'000), "it is of 0.50 s before the newest STOP");
  EXPECT_EQ(latch.hear(request(true, 2, kNow + 1'000'000), kNow + 1'100'000), StopHeard::kReleased)
      << "stamped anew, once the stop is told";
  latch.latch("two write JOINT_COMMAND", kNow + 2'000'000);
  EXPECT_EQ(latch.hear(request(true, 3, kNow + 1'900'000), kNow + 2'000'000), StopHeard::kStale) << "its own likewise";
}

TEST(StopLatch, AResetInVainIsEchoedWithTheReason) {
  StopLatch latch("JOINT_STATE");
  EXPECT_EQ(latch.hear(request(true, 1), kNow, "two write JOINT_COMMAND"), StopHeard::kRefused);
  EXPECT_TRUE(latch.latched());
  EXPECT_EQ(latch.reason(), "two write JOINT_COMMAND");
  EXPECT_EQ(latch.id(), 1);
}

TEST(StopLatch, TheMoverItselfLatches) {
  StopLatch latch("JOINT_STATE");
  latch.hear(request(true, 1), kNow);
  latch.latch("two write JOINT_COMMAND", kNow);
  EXPECT_TRUE(latch.latched());
  EXPECT_EQ(latch.id(), 1) << "the last request it obeyed";
}

}  // namespace
}  // namespace markservo::motion
