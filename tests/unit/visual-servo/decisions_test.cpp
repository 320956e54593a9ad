// What the decisions rest on: the goal, the stop's word, the pictures' time, where the arm was found.

#include <gtest/gtest.h>

#include "services/visual-servo/decisions/followed_goal.hpp"
#include "services/visual-servo/decisions/lost_arm.hpp"
#include "services/visual-servo/decisions/motion_enable.hpp"
#include "services/visual-servo/decisions/picture_clock.hpp"

namespace markservo::visual_servo::test {
namespace {

constexpr double kAge_s = 0.6;
constexpr std::int64_t kNow = 50'000'000;

Goal goal_at(std::int64_t utime, std::int64_t id = 1) {
  Goal goal;
  goal.utime = utime;
  goal.session = 5;
  goal.id = id;
  return goal;
}

PoseSample picture(std::int64_t utime, std::int64_t session = 3) {
  PoseSample pose;
  pose.utime = utime;
  pose.frame_session = session;
  return pose;
}

TEST(FollowedGoal, IsStaleUnlessItIsRepeated) {
  FollowedGoal followed;
  EXPECT_EQ(followed.observe(goal_at(kNow), kNow, kAge_s, false), motion::GoalHeard::kNew);
  EXPECT_EQ(followed.why_stale(kNow + 500'000, kAge_s), "");
  EXPECT_EQ(followed.why_stale(kNow + 700'000, kAge_s), "SERVO_GOAL is 0.70 s older than JOINT_STATE; allowed: 0.60 s");
  followed.observe(goal_at(kNow + 500'000), kNow + 500'000, kAge_s, false);
  EXPECT_EQ(followed.why_stale(kNow + 700'000, kAge_s), "");
}

TEST(FollowedGoal, SaysWhyItWasDroppedUntilTheNextOne) {
  FollowedGoal followed;
  EXPECT_EQ(followed.why_none(), "no goal");
  followed.drop("the arm began anew");
  EXPECT_EQ(followed.why_none(), "no goal") << "there was none to drop";
  followed.observe(goal_at(kNow), kNow, kAge_s, false);
  followed.drop("the arm began anew");
  EXPECT_FALSE(followed.goal());
  EXPECT_EQ(followed.why_none(), "the arm began anew: the goal was dropped");
  followed.observe(goal_at(kNow, 2), kNow, kAge_s, false);
  followed.end();
  EXPECT_EQ(followed.why_none(), "no goal");
}

TEST(FollowedGoal, ARefusalIsOfOneGoal) {
  FollowedGoal followed;
  followed.observe(goal_at(kNow), kNow, kAge_s, false);
  followed.refuse("too far");
  followed.observe(goal_at(kNow), kNow, kAge_s, false);
  EXPECT_EQ(followed.refusal(), "too far");
  followed.observe(goal_at(kNow, 2), kNow, kAge_s, false);
  EXPECT_EQ(followed.refusal(), "");
}

TEST(FollowedGoal, OneHeardBeforeAnyTimeIsJudgedByTheFirst) {
  FollowedGoal fresh;
  fresh.observe(goal_at(kNow), 0, kAge_s, false);
  fresh.end_unless_fresh(kNow + 300'000, kAge_s);
  EXPECT_TRUE(fresh.goal());
  FollowedGoal old;
  old.observe(goal_at(kNow), 0, kAge_s, false);
  old.end_unless_fresh(kNow + 3'000'000, kAge_s);
  EXPECT_FALSE(old.goal());
  EXPECT_EQ(old.observe(goal_at(kNow + 3'000'000), kNow + 3'000'000, kAge_s, false), motion::GoalHeard::kEnded);
}

TEST(FollowedGoal, HoldsWithoutAGoalAndByOneThatSaysSo) {
  FollowedGoal followed;
  EXPECT_TRUE(followed.holds());
  Goal goal = goal_at(kNow);
  goal.kind = GoalKind::kPosture;
  followed.observe(goal, kNow, kAge_s, false);
  EXPECT_FALSE(followed.holds());
  goal.kind = GoalKind::kHold;
  goal.id = 2;
  followed.observe(goal, kNow, kAge_s, false);
  EXPECT_TRUE(followed.holds());
}

TEST(LostArm, IsTakenOnceWhileItHolds) {
  LostArm lost;
  EXPECT_TRUE(lost.adopts(true));
  EXPECT_FALSE(lost.adopts(true));
  EXPECT_FALSE(lost.adopts(true));
  lost.forget();
  EXPECT_TRUE(lost.adopts(true)) << "by another goal";
}

TEST(LostArm, IsTakenEachTimeWhileItIsToMove) {
  LostArm lost;
  EXPECT_TRUE(lost.adopts(true));
  EXPECT_TRUE(lost.adopts(false));
  EXPECT_TRUE(lost.adopts(false));
  EXPECT_TRUE(lost.adopts(true)) << "it moved in between";
}

TEST(MotionEnable, IsNotGivenBeforeTheArmHasSpoken) {
  MotionEnable enable;
  EXPECT_FALSE(enable.released());
  EXPECT_FALSE(enable.latched());
  EXPECT_EQ(enable.why_stopped(), "no STOP_STATE of the arm yet");
  enable.observe_stop(true, "");
  EXPECT_TRUE(enable.latched());
  EXPECT_EQ(enable.why_stopped(), "STOP is latched");
  enable.observe_stop(true, "button");
  EXPECT_EQ(enable.why_stopped(), "button");
  enable.observe_stop(false, "");
  EXPECT_TRUE(enable.released());
  EXPECT_EQ(enable.why_stopped(), "");
}

TEST(PictureClock, TellsTheNextPictureFromOneAfterAGapAndOneOfAnotherWriter) {
  PictureClock clock;
  EXPECT_EQ(clock.advance(picture(kNow)), Succession::kOfAnotherWriter);
  EXPECT_EQ(clock.seconds(), 1.0 / 30.0);
  EXPECT_EQ(clock.advance(picture(kNow + 50'000)), Succession::kNext);
  EXPECT_NEAR(clock.seconds(), 0.05, 1e-12);
  EXPECT_EQ(clock.advance(picture(kNow + 250'000)), Succession::kNext);
  EXPECT_EQ(clock.seconds(), 0.1) << "a step fills no more";
  EXPECT_EQ(clock.advance(picture(kNow + 600'000)), Succession::kAfterAGap);
  EXPECT_EQ(clock.advance(picture(kNow, 4)), Succession::kOfAnotherWriter);
}

TEST(PictureClock, PassesWhatIsNotNewerOfItsWriter) {
  PictureClock clock;
  clock.advance(picture(kNow));
  EXPECT_TRUE(clock.has_passed(picture(kNow)));
  EXPECT_TRUE(clock.has_passed(picture(kNow - 33'333)));
  EXPECT_FALSE(clock.has_passed(picture(kNow + 1)));
  EXPECT_FALSE(clock.has_passed(picture(kNow, 4)));
  clock.begin_anew();
  EXPECT_FALSE(clock.has_passed(picture(kNow)));
}

}  // namespace
}  // namespace markservo::visual_servo::test
