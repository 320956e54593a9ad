#include <gtest/gtest.h>

#include "tests/unit/fault_campaign/forged_history.hpp"

namespace markservo::campaign {
namespace {

TEST(DeafOrMuteIsNotReady, HoldsForOneThatHearsAndSpeaks) {
  ForgedHistory forged;
  forged.still(0.0, 20.0).says(1.0, 20.0, "mark-detector", "ready", "STEREO_FRAME", 10);
  forged.messages(0.0, 20.0, "MARK_DETECTION", 10.0, 60000);
  const Verdict verdict = deaf_or_mute_is_not_ready(forged.timeline(), forged_bars());
  EXPECT_GT(verdict.judged, 5);
  EXPECT_FALSE(verdict.broken());
}

TEST(DeafOrMuteIsNotReady, BreaksForADeafOneThatSaysReady) {
  ForgedHistory forged;
  forged.still(0.0, 20.0).says(1.0, 20.0, "mark-detector", "ready", "STEREO_FRAME", 0);
  forged.messages(0.0, 20.0, "MARK_DETECTION", 10.0, 60000);
  EXPECT_TRUE(deaf_or_mute_is_not_ready(forged.timeline(), forged_bars()).broken());
}

TEST(DeafOrMuteIsNotReady, BreaksForAMuteOneThatSaysReady) {
  ForgedHistory forged;
  forged.still(0.0, 20.0).says(1.0, 20.0, "mark-detector", "ready", "STEREO_FRAME", 10);
  EXPECT_TRUE(deaf_or_mute_is_not_ready(forged.timeline(), forged_bars()).broken());
}

TEST(DeafOrMuteIsNotReady, HoldsNothingAgainstWhoHadNoNetwork) {
  ForgedHistory forged;
  forged.still(0.0, 6.0).says(1.0, 6.0, "mark-detector", "ready", "STEREO_FRAME", 10);
  forged.messages(0.0, 6.0, "MARK_DETECTION", 10.0, 60000);
  forged.still(16.0, 20.0).says(16.0, 20.0, "mark-detector", "ready", "STEREO_FRAME", 0);
  EXPECT_FALSE(deaf_or_mute_is_not_ready(forged.timeline(), forged_bars()).broken());
}

TEST(DeafOrMuteIsNotReady, LetsADeafOneWait) {
  ForgedHistory forged;
  forged.still(0.0, 20.0).says(1.0, 20.0, "mark-detector", "waiting", "STEREO_FRAME", 0);
  EXPECT_FALSE(deaf_or_mute_is_not_ready(forged.timeline(), forged_bars()).broken());
}

TEST(DeafOrMuteIsNotReady, BreaksForAHungProcessThatIsLeftAlone) {
  ForgedHistory forged;
  forged.still(0.0, 20.0).process(2.0, 12.0, "visual-servo", 'T');
  EXPECT_TRUE(deaf_or_mute_is_not_ready(forged.timeline(), forged_bars()).broken());
  ForgedHistory replaced;
  replaced.still(0.0, 20.0).process(2.0, 8.0, "visual-servo", 'T').process(8.0, 20.0, "visual-servo", 'S');
  EXPECT_FALSE(deaf_or_mute_is_not_ready(replaced.timeline(), forged_bars()).broken());
}

TEST(DeafOrMuteIsNotReady, CountsNothingWhileTheStackIsTakenDown) {
  ForgedHistory forged;
  forged.still(0.0, 20.0).says(1.0, 20.0, "mark-detector", "ready", "STEREO_FRAME", 0).ended(2.0);
  EXPECT_EQ(deaf_or_mute_is_not_ready(forged.timeline(), forged_bars()).judged, 0);
}

// The stack was well, was struck from 8 to 10 s, and is told of until 28 s.
ForgedHistory struck_stack(const std::string& after) {
  ForgedHistory forged;
  forged.still(0.0, 28.0).fault(8.0, 10.0, {"visual-servo"});
  forged.says(1.0, 8.0, "visual-servo", "ready").says(10.5, 28.0, "visual-servo", after);
  for (const char* service : {"simulator", "task-manager", "base-navigator", "mark-detector"}) {
    forged.says(1.0, 28.0, service, "ready");
  }
  return forged;
}

TEST(RecoversUnaided, HoldsWhenAllIsAsBefore) {
  ForgedHistory forged = struck_stack("ready");
  forged.process(0.0, 28.0, "visual-servo", 'S', 50.0).messages(0.0, 28.0, "JOINT_COMMAND", 10.0, 120);
  const Verdict verdict = recovers_unaided(forged.timeline(), forged_bars());
  EXPECT_GT(verdict.judged, 5);
  EXPECT_FALSE(verdict.broken()) << verdict.breaches[0].evidence;
}

TEST(RecoversUnaided, BreaksWhenOneStaysBehind) {
  EXPECT_TRUE(recovers_unaided(struck_stack("waiting").timeline(), forged_bars()).broken());
}

TEST(RecoversUnaided, BreaksWhenOneIsGone) {
  ForgedHistory forged;
  forged.still(0.0, 28.0).fault(8.0, 10.0, {"visual-servo"}).says(1.0, 8.0, "visual-servo", "ready");
  EXPECT_TRUE(recovers_unaided(forged.timeline(), forged_bars()).broken());
}

TEST(RecoversUnaided, BreaksWhenMemoryGrew) {
  ForgedHistory forged = struck_stack("ready");
  forged.process(1.0, 8.0, "visual-servo", 'S', 50.0).process(10.5, 28.0, "visual-servo", 'S', 61.0);
  EXPECT_TRUE(recovers_unaided(forged.timeline(), forged_bars()).broken());
}

TEST(RecoversUnaided, BreaksWhenMessagesStayLarge) {
  ForgedHistory forged = struck_stack("ready");
  forged.messages(0.0, 8.0, "STOP_STATE", 10.0, 80).messages(8.0, 28.0, "STOP_STATE", 10.0, 1000080);
  EXPECT_TRUE(recovers_unaided(forged.timeline(), forged_bars()).broken());
}

TEST(RecoversUnaided, BreaksWhenMessagesStayMany) {
  ForgedHistory forged = struck_stack("ready");
  forged.messages(0.0, 8.0, "STOP_STATE", 10.0, 80).messages(8.0, 28.0, "STOP_STATE", 100.0, 80);
  EXPECT_TRUE(recovers_unaided(forged.timeline(), forged_bars()).broken());
}

TEST(RecoversUnaided, BreaksForAnEighthMoreOnAllChannels) {
  ForgedHistory forged = struck_stack("ready");
  forged.messages(0.0, 8.0, "WHEEL_ODOMETRY", 50.0, 56).messages(8.0, 28.0, "WHEEL_ODOMETRY", 50.0, 66);
  EXPECT_TRUE(recovers_unaided(forged.timeline(), forged_bars()).broken());
  ForgedHistory healthy = struck_stack("ready");
  healthy.messages(0.0, 8.0, "WHEEL_ODOMETRY", 50.0, 56).messages(8.0, 28.0, "WHEEL_ODOMETRY", 52.0, 57);
  EXPECT_FALSE(recovers_unaided(healthy.timeline(), forged_bars()).broken());
}

TEST(RecoversUnaided, BreaksWhenTheStackAsksForEver) {
  ForgedHistory forged = struck_stack("ready");
  forged.messages(9.0, 28.0, "STOP", 5.0, 80);
  EXPECT_TRUE(recovers_unaided(forged.timeline(), forged_bars()).broken());
  ForgedHistory once = struck_stack("ready");
  once.messages(9.0, 11.5, "STOP", 5.0, 80);
  EXPECT_FALSE(recovers_unaided(once.timeline(), forged_bars()).broken());
}

TEST(RecoversUnaided, BreaksForAServiceThatIsReadyNowAndThen) {
  ForgedHistory forged = struck_stack("waiting");
  for (double t = 10.3; t < 28.0; t += 1.0) forged.says(t, t + 0.1, "visual-servo", "ready");
  EXPECT_TRUE(recovers_unaided(forged.timeline(), forged_bars()).broken());
  ForgedHistory mostly = struck_stack("ready");
  mostly.says(24.0, 24.1, "visual-servo", "stale").says(24.2, 24.3, "visual-servo", "ready");
  EXPECT_FALSE(recovers_unaided(mostly.timeline(), forged_bars()).broken());
}

TEST(RecoversUnaided, BreaksForALongText) {
  ForgedHistory forged = struck_stack("ready");
  forged.task_state(15.0, TaskState::IDLE, std::string(201, 'x'));
  EXPECT_TRUE(recovers_unaided(forged.timeline(), forged_bars()).broken());
  ForgedHistory bounded = struck_stack("ready");
  bounded.task_state(15.0, TaskState::IDLE, std::string(200, 'x'));
  EXPECT_FALSE(recovers_unaided(bounded.timeline(), forged_bars()).broken());
}

TEST(DeafOrMuteIsNotReady, KnowsAllThatAServiceNeeds) {
  ForgedHistory forged;
  forged.still(0.0, 20.0).says(1.0, 20.0, "visual-servo", "ready", "SERVO_GOAL", 5);
  std::string evidence;
  for (const Breach& breach : deaf_or_mute_is_not_ready(forged.timeline(), forged_bars()).breaches) {
    evidence += breach.evidence + "\n";
  }
  for (const char* channel : {"TARGET_POSE", "JOINT_STATE", "STOP_STATE"}) {
    EXPECT_NE(evidence.find(channel), std::string::npos) << channel;
  }
}

}  // namespace
}  // namespace markservo::campaign
