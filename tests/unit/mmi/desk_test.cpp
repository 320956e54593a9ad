// Operators' commands: who may, what is sent, and that nothing is done twice or late.

#include "services/mmi/control/desk.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/unit/mmi/robot_of_the_project.hpp"

namespace markservo::mmi {
namespace {

using ::testing::HasSubstr;

constexpr std::int64_t kPage = 101;
constexpr std::int64_t kOther = 202;
constexpr const char* kToken = "a token of commands";

class ADesk : public ::testing::Test {
 protected:
  ADesk() : desk_(robot_of_the_project(), kToken, [this] { return ++resets_; }) {
    for (const std::int64_t session : {kPage, kOther}) {
      desk_.arrive(session);
      desk_.hear_token(session, kToken);
    }
    desk_.lease(kPage, true, false, now_);
    say(false);
  }

  std::int64_t utime() const { return 1'700'000'000'000'000 + static_cast<std::int64_t>(1e6 * now_); }

  // A word of each device and of the task.
  void say(bool latched, const std::string& reason = {}, TaskPhase phase = TaskPhase::kIdle, std::int64_t ours = 0) {
    for (const char* device : {"arm", "base"}) {
      desk_.observe(task::StopReport{device, latched, false, reason}, reset_heard_, !reason.empty(), now_);
    }
    say_task(phase, ours);
  }
  void say_task(TaskPhase phase, std::int64_t ours = 0) {
    desk_.observe(task::TaskReport{now_, task::Answers::kNobody, phase, 1, "red_book", ""}, ours, now_);
  }

  CommandStamp next(double life = 1.5) { return {kPage, ++seq_, utime() + static_cast<std::int64_t>(1e6 * life)}; }
  void wish(task::Action action, const std::string& target = "red_book") { wish(next(), action, target); }
  void wish(const CommandStamp& stamp, task::Action action, const std::string& target = "red_book") {
    Command command;
    command.action = action;
    command.target = target;
    desk_.command(kPage, stamp, command, now_, utime());
  }

  // The answers so far, as "state code".
  std::vector<std::string> answers(std::int64_t session = kPage) {
    std::vector<std::string> all;
    const std::string text = desk_.take_answers(session);
    if (text.empty()) return all;
    for (const auto& answer : nlohmann::json::parse(text)) {
      all.push_back(answer["state"].get<std::string>() + " " + answer["code"].get<std::string>());
      last_text_ = answer["text"];
    }
    return all;
  }
  nlohmann::json view(std::int64_t session = kPage) const {
    return nlohmann::json::parse(desk_.view(session, now_, utime()));
  }
  std::size_t sent() { return desk_.step(now_).size(); }

  double now_ = 10.0;
  std::int64_t resets_ = 0;
  std::int64_t reset_heard_ = 0;
  std::int64_t seq_ = 0;
  std::string last_text_;
  Desk desk_;
};

TEST_F(ADesk, SendsAStartAtOnceRepeatsItUntilItIsEchoedAndFollowsItToItsEnd) {
  wish(task::Action::kStart);
  const auto first = desk_.step(now_);
  ASSERT_EQ(first.size(), 1U);
  EXPECT_EQ(first[0].command.target, "red_book");
  now_ += 0.25;
  const auto again = desk_.step(now_);
  ASSERT_EQ(again.size(), 1U);
  EXPECT_EQ(again[0].id, first[0].id);
  say_task(TaskPhase::kServo, first[0].id);
  now_ += 0.25;
  EXPECT_EQ(sent(), 0U);
  say_task(TaskPhase::kHoldLifted, first[0].id);
  EXPECT_EQ(sent(), 0U);
  EXPECT_EQ(answers(), (std::vector<std::string>{"sent ", "under_way ", "done "}));
}

TEST_F(ADesk, SendsNothingForAReplayedAReorderedAnExpiredOrAnEarlyCommand) {
  const CommandStamp good = next();
  wish(good, task::Action::kHome);
  EXPECT_EQ(sent(), 1U);
  answers();
  wish(good, task::Action::kHome);
  wish(CommandStamp{kPage, 0, utime() + 1'000'000}, task::Action::kHome);
  wish(next(-0.001), task::Action::kHome);
  wish(next(2.1), task::Action::kHome);
  wish(CommandStamp{kOther, 50, utime() + 1'000'000}, task::Action::kHome);
  EXPECT_EQ(sent(), 0U);
  EXPECT_EQ(answers(), (std::vector<std::string>{"refused replayed", "refused replayed", "refused expired",
                                                 "refused too_far_ahead", "refused other_session"}));
  EXPECT_EQ(desk_.refused().at("replayed"), 2);
}

TEST_F(ADesk, NeedsTheTokenAndTheLease) {
  Command home;
  home.action = task::Action::kHome;
  desk_.command(kOther, {kOther, 1, utime() + 1'000'000}, home, now_, utime());
  EXPECT_EQ(answers(kOther), std::vector<std::string>{"refused no_lease"});
  desk_.hear_token(kOther, "a guess");
  desk_.lease(kOther, true, true, now_);
  desk_.command(kOther, {kOther, 2, utime() + 1'000'000}, home, now_, utime());
  EXPECT_EQ(answers(kOther), std::vector<std::string>{"refused no_token"});
  EXPECT_EQ(view()["holder"], "you") << "who may not command takes no lease";
  EXPECT_EQ(sent(), 0U);
}

TEST_F(ADesk, HasOneOperatorWhoseLeaseEndsFiveSecondsAfterTheLastWord) {
  EXPECT_EQ(view(kOther)["holder"], "another");
  desk_.lease(kOther, true, false, now_);
  EXPECT_EQ(view(kPage)["holder"], "you") << "it was not taken over";
  desk_.lease(kOther, true, true, now_);
  EXPECT_EQ(view(kPage)["holder"], "another");
  EXPECT_EQ(view(kOther)["holder"], "you");
  now_ += 5.1;
  EXPECT_EQ(view(kPage)["holder"], "none");
  say(false);
  wish(task::Action::kHome);
  EXPECT_EQ(answers(), std::vector<std::string>{"refused no_lease"});
}

TEST_F(ADesk, SaysWhyACommandCannotWorkAndSendsNothing) {
  say(true, "task-operator: asked");
  EXPECT_THAT(view()["why"]["start"].get<std::string>(), HasSubstr("reset releases it"));
  EXPECT_THAT(view()["why"]["reset"].get<std::string>(), HasSubstr("another stopped it"));
  wish(task::Action::kStart);
  wish(task::Action::kReset);
  say(false, "", TaskPhase::kServo);
  EXPECT_THAT(view()["why"]["home"].get<std::string>(), HasSubstr("abort ends it"));
  EXPECT_EQ(view()["why"]["abort"], "");
  wish(task::Action::kStart);
  now_ += 3.0;
  desk_.lease(kPage, true, false, now_);
  say_task(TaskPhase::kIdle);
  EXPECT_THAT(view()["why"]["reset"].get<std::string>(), HasSubstr("no STOP_STATE of arm, base"));
  wish(task::Action::kReset);
  wish(task::Action::kDrive);
  EXPECT_EQ(sent(), 0U);
  EXPECT_EQ(answers(), std::vector<std::string>(5, "refused cannot"));
}

TEST_F(ADesk, ReleasesAStopOfAPageAndTheStateInWhichDevicesComeUp) {
  say(true, "page: asked");
  EXPECT_EQ(view()["why"]["reset"], "");
  say(true);
  EXPECT_EQ(view()["why"]["reset"], "");
  wish(task::Action::kReset);
  const auto to_send = desk_.step(now_);
  ASSERT_EQ(to_send.size(), 1U);
  EXPECT_EQ(to_send[0].command.action, task::Action::kReset);
  EXPECT_EQ(to_send[0].id, 1);
  reset_heard_ = 1;
  say(false);
  desk_.step(now_);
  EXPECT_EQ(answers().back(), "done ");
}

TEST_F(ADesk, RefusesAMarkThatIsNoTarget) {
  wish(task::Action::kStart, "hand");
  EXPECT_EQ(answers(), std::vector<std::string>{"refused unknown_target"});
}

TEST_F(ADesk, SendsOneCommandThatMovesAtATime) {
  wish(task::Action::kHome);
  wish(task::Action::kStart);
  EXPECT_EQ(sent(), 1U);
  EXPECT_EQ(answers(), (std::vector<std::string>{"refused busy", "sent "}));
  say_task(TaskPhase::kGoHome, 1);
  wish(task::Action::kAbort);
  EXPECT_EQ(sent(), 1U) << "what moves can be ended";
}

TEST_F(ADesk, GivesUpACommandThatNobodyEchoesAfterTwoSeconds) {
  wish(task::Action::kHome);
  std::size_t sent_in_all = 0;
  for (int i = 0; i < 60; ++i) {
    sent_in_all += sent();
    now_ += 0.1;
    desk_.lease(kPage, true, false, now_);
  }
  EXPECT_LE(sent_in_all, 11U);
  EXPECT_EQ(answers().back(), "unanswered ");
}

TEST_F(ADesk, GoesOnWithWhatAPageBeganThatIsGone) {
  wish(task::Action::kHome);
  EXPECT_EQ(sent(), 1U);
  desk_.leave(kPage);
  now_ += 0.25;
  EXPECT_EQ(sent(), 1U);
  EXPECT_EQ(view(kOther)["holder"], "none");
}

TEST_F(ADesk, KeepsFewAnswersForWhoTakesNone) {
  for (int i = 0; i < 300; ++i) wish(next(-1.0), task::Action::kHome);
  EXPECT_TRUE(desk_.is_behind(kPage));
  EXPECT_FALSE(desk_.is_behind(kOther));
}

}  // namespace
}  // namespace markservo::mmi
