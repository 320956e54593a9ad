#include "services/mmi/feed/client_feed.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <markservo/JointState.hpp>
#include <markservo/TaskState.hpp>
#include <nlohmann/json.hpp>

#include "tests/unit/mmi/frame_messages.hpp"
#include "tests/unit/mmi/robot_of_the_project.hpp"

namespace markservo::mmi {
namespace {

constexpr std::int64_t kBegin_us = 1'600'000'000'000'000;

class SharedWorld final : public Shown {
 public:
  explicit SharedWorld(WorldReader& world) : world_(world) {}
  WorldReader& world() override { return world_; }
  const EventLog& events() override { return world_.events(); }
  std::int64_t utime() override { return 1; }
  std::string control(const ClientWord& /*message*/) override { return "not of a robot"; }

 private:
  WorldReader& world_;
};

// A client that takes what it is told at once, unless it stalls.
class FedClient : public ::testing::Test, private FeedHost {
 protected:
  FedClient() : world_(robot_of_the_project(), ""), feed_(*this, std::make_unique<SharedWorld>(world_)) {}

  void greet() { ASSERT_EQ(feed_.hear(R"({"type":"hello","protocol":1,"token":"secret"})"), ""); }

  // All that is sent now.
  std::vector<OutgoingMessage> sent() {
    std::vector<OutgoingMessage> messages;
    while (auto message = feed_.next()) messages.push_back(std::move(*message));
    return messages;
  }

  // The same, at the next update's time, as JSON; pictures by their headers. Acknowledges unless it stalls.
  std::vector<nlohmann::json> told() {
    now_ += 0.07;
    std::vector<nlohmann::json> all;
    for (const OutgoingMessage& message : sent()) {
      const std::string& data = *message.data;
      const std::size_t length =
          message.binary ? static_cast<unsigned char>(data[0]) + 256U * static_cast<unsigned char>(data[1]) : 0;
      all.push_back(nlohmann::json::parse(message.binary ? data.substr(4, length) : data));
      const auto number = all.back().find("number");
      if (stalls_ || number == all.back().end()) continue;
      const std::string kind = message.binary ? "seen" : "took";
      feed_.hear(R"({"type":")" + kind + R"(","number":)" + number->dump() + "}");
    }
    return all;
  }

  template <class M>
  void say(const std::string& channel, M message) {
    message.session = 5;
    message.seq = ++seq_;
    message.utime = kBegin_us + seq_;
    const auto bytes = test::encoded(message);
    world_.observe(channel, bytes.data(), bytes.size(), message.utime, now_);
  }
  void say_phase(int phase) {
    TaskState state{};
    state.state = static_cast<std::int8_t>(phase);
    state.frame_session = 1;
    state.frame_seq = 1;
    state.frame_utime = kBegin_us + seq_ + 1;
    say("TASK_STATE", state);
  }
  void say_frame() {
    frames_.seq = ++seq_;
    const auto frame = frames_.frame();
    world_.observe("STEREO_FRAME", frame.data(), frame.size(), seq_, now_);
    for (const auto& [channel, bytes] : frames_.answers()) {
      world_.observe(channel, bytes.data(), bytes.size(), seq_, now_);
    }
  }

  static std::vector<std::string> texts(const std::vector<nlohmann::json>& told) {
    std::vector<std::string> texts;
    for (const auto& message : told) {
      if (!message.contains("events")) continue;
      for (const auto& event : message["events"]) texts.push_back(event["text"]);
    }
    return texts;
  }

  WorldReader world_;
  ClientFeed feed_;
  FrameMessages frames_;
  VersionedText stop_{1, "{}"};
  std::string stopped_for_;
  double now_ = 1.0;
  bool stalls_ = false;
  std::int64_t seq_ = 0;

 private:
  const std::string& hello() const override { return hello_; }
  bool admits(const std::string& token) const override { return token == "secret"; }
  std::string stop(const std::string& reason) override {
    stopped_for_ = reason;
    return {};
  }
  const VersionedText& stop_state() const override { return stop_; }
  PictureMaker& pictures() override { return pictures_; }
  double now() const override { return now_; }
  std::int64_t new_session() override { return 77; }

  std::string hello_ = R"({"type":"hello")";
  PictureMaker pictures_;
};

TEST_F(FedClient, ComesInAfterMoreEventsThanAreKept) {
  for (int i = 0; i < 3000; ++i) say_phase(i % 10);
  greet();
  EXPECT_EQ(feed_.trouble(), "") << "nothing has been left out: it was told nothing yet";
  const auto all = told();
  ASSERT_FALSE(all.empty());
  EXPECT_EQ(all[0]["type"], "hello");
  EXPECT_EQ(all[0]["events"].size(), 2000U);
  EXPECT_EQ(feed_.trouble(), "");
}

TEST_F(FedClient, IsToldNothingBeforeItsHello) {
  say_phase(1);
  EXPECT_TRUE(sent().empty());
  EXPECT_NE(feed_.hear(R"({"type":"pictures","on":true})"), "");
}

TEST_F(FedClient, IsRefusedWithAnotherToken) {
  EXPECT_NE(feed_.hear(R"({"type":"hello","protocol":1,"token":"guess"})"), "");
  EXPECT_FALSE(feed_.greeted());
}

TEST_F(FedClient, StopsTheRobotWithoutAHello) {
  EXPECT_EQ(feed_.hear(R"({"type":"stop","reason":"smoke"})"), "");
  EXPECT_EQ(stopped_for_, "smoke");
}

TEST_F(FedClient, IsToldThePresentStateFirst) {
  say_phase(1);
  say_phase(3);
  greet();
  const auto all = told();
  ASSERT_EQ(all.size(), 2U);
  EXPECT_EQ(all[0]["type"], "hello");
  EXPECT_EQ(texts(all).size(), 2U);
  ASSERT_EQ(all[1]["slots"].size(), 1U);
  EXPECT_EQ(all[1]["slots"][0]["message"]["state"], 3);
}

TEST_F(FedClient, IsToldEachChangeOfStateOnceAndInOrder) {
  greet();
  told();
  std::vector<std::string> heard;
  for (int phase = 1; phase <= 10; ++phase) {
    say_phase(phase);
    say_phase(phase);
    if (phase % 3 == 0) {
      for (const std::string& text : texts(told())) heard.push_back(text);
    }
  }
  for (const std::string& text : texts(told())) heard.push_back(text);
  ASSERT_EQ(heard.size(), 10U);
  EXPECT_EQ(std::count_if(heard.begin(), heard.end(), [](const auto& text) { return text.find("SERVO") == 0; }), 1);
}

TEST_F(FedClient, IsToldTheNewestOfWhatIsMeasured) {
  greet();
  told();
  for (int i = 0; i < 100; ++i) say("JOINT_STATE", JointState{});
  const auto all = told();
  ASSERT_EQ(all.size(), 1U);
  ASSERT_EQ(all[0]["slots"].size(), 1U);
  EXPECT_EQ(all[0]["slots"][0]["message"]["seq"], std::to_string(seq_));
}

TEST_F(FedClient, IsToldLargeMessagesOnlyWhereItLooks) {
  greet();
  say_frame();
  const auto has_detection = [](const std::vector<nlohmann::json>& all) {
    return all.back().dump().find("MARK_DETECTION") != std::string::npos;
  };
  EXPECT_FALSE(has_detection(told()));
  feed_.hear(R"({"type":"look","channels":["MARK_DETECTION"]})");
  EXPECT_TRUE(has_detection(told()));
}

TEST_F(FedClient, GetsPicturesOnlyWhileItLooksAndHasSeenTheLast) {
  greet();
  told();
  const auto pictures = [this] {
    say_frame();
    const auto all = told();
    return std::count_if(all.begin(), all.end(), [](const auto& one) { return one.contains("left_size"); });
  };
  EXPECT_EQ(pictures(), 0);
  feed_.hear(R"({"type":"pictures","on":true})");
  EXPECT_EQ(pictures(), 1);
  stalls_ = true;
  EXPECT_EQ(pictures() + pictures() + pictures() + pictures(), 2);
  stalls_ = false;
  feed_.hear(R"({"type":"seen","number":3})");
  EXPECT_EQ(pictures(), 1);
}

TEST_F(FedClient, ThatStallsIsNotSentMoreAndMissesNoEvent) {
  greet();
  told();
  stalls_ = true;
  std::size_t updates = 0;
  for (int i = 0; i < 100; ++i) {
    say_phase(i % 2 == 0 ? 1 : 2);
    updates += told().size();
  }
  EXPECT_EQ(updates, 8U);
  stalls_ = false;
  feed_.hear(R"({"type":"took","number":9})");
  EXPECT_EQ(texts(told()).size(), 92U);
}

TEST_F(FedClient, ThatWouldMissAnEventIsLetGo) {
  greet();
  told();
  EXPECT_EQ(feed_.trouble(), "");
  for (int i = 0; i < 3000; ++i) say_phase(i % 2 == 0 ? 1 : 2);
  EXPECT_NE(feed_.trouble(), "");
}

TEST_F(FedClient, IsToldWhenTheStopChanges) {
  greet();
  told();
  stop_ = {2, R"({"state":"requested"})"};
  EXPECT_EQ(told().back()["stop"]["state"], "requested");
  EXPECT_TRUE(told().empty() || !told().back().contains("stop"));
}

TEST_F(FedClient, IsToldThatNothingIsNew) {
  greet();
  told();
  EXPECT_TRUE(told().empty());
  now_ += 0.25;
  const auto all = told();
  ASSERT_EQ(all.size(), 1U);
  EXPECT_EQ(all[0].size(), 3U) << all[0];
}

TEST_F(FedClient, HasNoTimeToTurnBackOnARobot) {
  greet();
  EXPECT_NE(feed_.hear(R"({"type":"seek","utime":"5"})"), "");
}

}  // namespace
}  // namespace markservo::mmi
