#include "services/mmi/log/log_shown.hpp"

#include <gtest/gtest.h>

#include <markservo/SonarScan.hpp>
#include <markservo/StopState.hpp>
#include <markservo/TaskState.hpp>
#include <nlohmann/json.hpp>

#include "common/logs/log_files.hpp"
#include "common/reflection/type_catalog.hpp"
#include "common/robot/configuration_error.hpp"
#include "services/mmi/log/log_source.hpp"
#include "services/mmi/log/log_story_reader.hpp"
#include "tests/unit/mmi/frame_messages.hpp"
#include "tests/unit/mmi/robot_of_the_project.hpp"
#include "tests/unit/temporary_folder.hpp"

namespace markservo::mmi {
namespace {

constexpr std::int64_t kBegin = 1'600'000'000'000'000;  // us

// Ten seconds of a robot: a frame with its answers each 0.1 s, a task state each second, each device's stop state once.
class ALog : public ::testing::Test {
 protected:
  ALog() {
    add(0.0, "STOP_STATE", stop_state("arm"));
    add(0.1, "STOP_STATE", stop_state("base"));
    FrameMessages frames;
    for (int i = 0; i < 100; ++i) {
      frames.seq = i + 1;
      const double time = 0.1 * i + 0.05;
      add(time, "STEREO_FRAME", frames.frame());
      double delay = 0.0;
      for (const auto& [channel, bytes] : frames.answers()) add(time + (delay += 0.005), channel, bytes);
      if (i % 10 == 0) add(time, "TASK_STATE", task_state(i / 10));
    }
    write();
  }

  void add(double time, const std::string& channel, std::vector<std::uint8_t> bytes) {
    channels_.push_back(std::make_unique<std::string>(channel));
    contents_.push_back(std::make_unique<std::vector<std::uint8_t>>(std::move(bytes)));
    const auto number = static_cast<std::int64_t>(events_.size());
    events_.push_back({number,
                       kBegin + static_cast<std::int64_t>(1e6 * time),
                       *channels_.back(),
                       {contents_.back()->data(), contents_.back()->size()}});
  }

  void write() {
    logs::write_log(folder_.file("log"), events_);
    source_ = std::make_unique<LogSource>(folder_.file("log"), "", robot_of_the_project(), "");
    while (source_->read_on()) {
    }
    shown_ = source_->shown();
  }

  static std::vector<std::uint8_t> stop_state(const std::string& device) {
    StopState state{};
    state.utime = kBegin;
    state.session = 3;
    state.seq = 1;
    state.device = device;
    return test::encoded(state);
  }
  static std::vector<std::uint8_t> task_state(int phase) {
    TaskState state{};
    state.utime = kBegin + phase;
    state.frame_session = 1;
    state.frame_seq = 1;
    state.frame_utime = state.utime;
    state.session = 4;
    state.seq = phase + 1;
    state.state = static_cast<std::int8_t>(phase);
    return test::encoded(state);
  }

  void seek(double time) { shown_->control(ClientSeek{kBegin + static_cast<std::int64_t>(1e6 * time)}); }
  void pass(double seconds) {
    for (double passed = 0.0; passed < seconds; passed += 0.05) shown_->advance(now_ += 0.05);
  }
  double time() const { return 1e-6 * static_cast<double>(shown_->utime() - kBegin); }
  std::int64_t picture() const {
    const auto frame = shown_->picture();
    return frame ? frame->seq : 0;
  }
  std::string slots() const {
    std::string all;
    for (const MessageSlots::Slot* slot : shown_->world().slots().since(0)) all += slot->json() + "\n";
    return all;
  }

  test::TemporaryFolder folder_;
  std::vector<std::unique_ptr<std::string>> channels_;
  std::vector<std::unique_ptr<std::vector<std::uint8_t>>> contents_;
  std::vector<logs::LogEvent> events_;
  std::unique_ptr<LogSource> source_;
  std::unique_ptr<Shown> shown_;
  double now_ = 50.0;
};

TEST_F(ALog, OpensAtItsFirstCompletePicture) {
  EXPECT_EQ(picture(), 1);
  EXPECT_LT(time(), 0.2);
}

TEST_F(ALog, ShowsAtEachInstantTheNewestMessageOfEveryChannelBefore) {
  seek(8.2);
  EXPECT_EQ(shown_->world().slots().find("STEREO_FRAME", "")->at, kBegin + 8'150'000);
  EXPECT_NE(shown_->world().slots().find("TASK_STATE", "")->json().find("\"state\":8"), std::string::npos);
  // Said once, long before.
  EXPECT_NE(shown_->world().slots().find("STOP_STATE", "arm"), nullptr);
  EXPECT_NE(shown_->world().slots().find("STOP_STATE", "base"), nullptr);
  seek(0.3);
  EXPECT_NE(shown_->world().slots().find("TASK_STATE", "")->json().find("\"state\":0"), std::string::npos);
}

TEST_F(ALog, IsTheSameAtTheSameInstantHoweverOneGotThere) {
  seek(5.0);
  const std::string before = slots();
  const std::string troubles = shown_->world().trouble_list().text;
  seek(9.0);
  seek(1.0);
  seek(5.0);
  EXPECT_EQ(slots(), before);
  EXPECT_EQ(shown_->world().trouble_list().text, troubles);
  EXPECT_EQ(picture(), 50);
}

TEST_F(ALog, PlaysAtTheSpeedThatIsAsked) {
  seek(1.0);
  pass(1.0);
  EXPECT_NEAR(time(), 1.0, 1e-9);
  shown_->control(ClientPlay{2.0});
  pass(1.0);
  EXPECT_NEAR(time(), 3.0, 0.11);
  EXPECT_NE(shown_->world().slots().find("TASK_STATE", "")->json().find("\"state\":2"), std::string::npos);
  shown_->control(ClientPause{});
  pass(1.0);
  EXPECT_NEAR(time(), 3.0, 0.11);
}

TEST_F(ALog, StopsAtItsEndAndBeginsAnewWhenPlayedAgain) {
  seek(9.8);
  shown_->control(ClientPlay{1.0});
  pass(2.0);
  EXPECT_NE(shown_->play().text.find("\"playing\":false"), std::string::npos);
  EXPECT_NEAR(time(), 10.0, 0.2);
  shown_->control(ClientPlay{1.0});
  pass(0.1);
  EXPECT_LT(time(), 0.2);
}

TEST_F(ALog, StepsFromPictureToPicture) {
  seek(5.0);
  const std::int64_t before = picture();
  shown_->control(ClientStep{1});
  EXPECT_EQ(picture(), before + 1);
  shown_->control(ClientStep{1});
  EXPECT_EQ(picture(), before + 2);
  shown_->control(ClientStep{-1});
  EXPECT_EQ(picture(), before + 1);
  seek(0.0);
  shown_->control(ClientStep{-1});
  EXPECT_EQ(picture(), 1);
  seek(99.0);
  shown_->control(ClientStep{1});
  EXPECT_EQ(picture(), 100);
}

TEST_F(ALog, StepsOverEachPictureWhereTheAnswersComeAfterTheNextOne) {
  std::vector<logs::LogEvent> late;
  for (const logs::LogEvent& event : events_) {
    late.push_back(event);
    if (FrameRing::is_answer(event.channel)) late.back().utime += 150'000;
  }
  logs::write_log(folder_.file("late"), late);
  LogSource source(folder_.file("late"), "", robot_of_the_project(), "");
  const auto shown = source.shown();
  ASSERT_TRUE(shown->picture()) << "it opens with a picture";
  for (int seq = 1; seq < 10; ++seq) {
    ASSERT_TRUE(shown->picture());
    EXPECT_EQ(shown->picture()->seq, seq);
    shown->control(ClientStep{1});
  }
  shown->control(ClientStep{-1});
  EXPECT_EQ(shown->picture()->seq, 9);
}

TEST_F(ALog, DoesTheNewestOfManyWishesAlone) {
  const std::uint64_t before = shown_->generation();
  for (int i = 0; i < 1000; ++i) seek(0.005 * i);
  EXPECT_EQ(shown_->generation(), before + 1);
  EXPECT_NEAR(time(), 4.995, 1e-6);
}

TEST_F(ALog, TellsAClientThatItsTimeIsAnother) {
  const std::uint64_t before = shown_->generation();
  seek(5.0);
  EXPECT_GT(shown_->generation(), before);
}

TEST_F(ALog, KeepsTimesThatNobodyCanAskForWithinIt) {
  for (const std::int64_t utime : {INT64_MIN, std::int64_t{0}, INT64_MAX}) {
    shown_->control(ClientSeek{utime});
    EXPECT_GE(time(), 0.0);
    EXPECT_LE(time(), 11.0);
  }
}

TEST_F(ALog, HasItsEventsFromBeginToEnd) {
  const auto events = nlohmann::json::parse(shown_->events().list_after(0));
  int tasks = 0;
  for (const auto& event : events) tasks += event["kind"] == "task" ? 1 : 0;
  EXPECT_EQ(tasks, 10);
}

TEST_F(ALog, WithTimesThatCannotBeIsShownAllTheSame) {
  events_[3].utime = INT64_MAX;
  events_[4].utime = INT64_MIN;
  logs::write_log(folder_.file("other"), events_);
  LogSource source(folder_.file("other"), "", robot_of_the_project(), "");
  while (source.read_on()) {
  }
  const auto shown = source.shown();
  shown->control(ClientSeek{INT64_MAX});
  EXPECT_NE(shown->world().slots().find("STOP_STATE", "base"), nullptr);
  shown->control(ClientPlay{1.0});
  for (int i = 0; i < 100; ++i) shown->advance(i);
}

TEST_F(ALog, IsOfOneRobot) {
  EXPECT_THROW(LogSource(folder_.file("log"), "other/", robot_of_the_project(), ""), ConfigurationError);
}

}  // namespace
}  // namespace markservo::mmi
