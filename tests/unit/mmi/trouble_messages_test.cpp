#include "services/mmi/troubles/trouble_messages.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <markservo/BaseStatus.hpp>
#include <markservo/ProcessStatus.hpp>
#include <markservo/RobotPose.hpp>
#include <markservo/ServiceStatus.hpp>
#include <markservo/StereoFrame.hpp>
#include <markservo/StopState.hpp>
#include <markservo/TargetPose.hpp>
#include <markservo/TaskState.hpp>

#include "common/bus/subscription.hpp"
#include "services/mmi/troubles/watches/service_reason.hpp"
#include "tests/unit/encoded.hpp"

namespace markservo::mmi {
namespace {

using ::testing::HasSubstr;

class TroubleMessages : public ::testing::Test {
 protected:
  // Why the message was not observed.
  template <class M>
  std::string hear(const std::string& channel, const M& message) {
    const auto bytes = test::encoded(message);
    return observe_message(channel, bytes.data(), bytes.size(), utime, now, troubles, state);
  }
  template <class M>
  M stream() const {
    M message{};
    message.utime = utime;
    message.session = 7;
    message.seq = 1;
    return message;
  }
  std::vector<TroubleCode> codes_after(double seconds) {
    now += seconds;
    std::vector<TroubleCode> codes;
    for (const Trouble& trouble : troubles.step(now)) codes.push_back(trouble.code);
    return codes;
  }

  std::int64_t utime = 1'600'000'000'000'000;
  double now = 10.0;
  TroubleWatch troubles{{"arm"}};
  RobotState state;
};

TEST_F(TroubleMessages, TellsTroublesAndStateOfWhatWasHeard) {
  auto task = stream<TaskState>();
  task.frame_utime = utime;
  task.state = TaskState::REFUSED;
  task.target = "red_book";
  task.reason = "out of reach";
  EXPECT_EQ(hear("TASK_STATE", task), "");
  ASSERT_TRUE(state.task());
  EXPECT_EQ(state.task()->phase, TaskPhase::kRefused);
  EXPECT_EQ(state.task_since_utime(), utime);
  EXPECT_EQ(codes_after(0.0), std::vector<TroubleCode>{TroubleCode::kTargetRefused});
}

TEST_F(TroubleMessages, WhatBreaksARuleIsNotObserved) {
  auto task = stream<TaskState>();
  task.frame_utime = utime;
  task.state = 99;
  EXPECT_THAT(hear("TASK_STATE", task), HasSubstr("state is 99"));
  auto pose = stream<RobotPose>();
  pose.pose.x = std::nan("");
  EXPECT_THAT(hear("ROBOT_POSE", pose), HasSubstr("pose.x"));
  EXPECT_FALSE(state.task());
  EXPECT_FALSE(state.pose());
  EXPECT_TRUE(codes_after(0.0).empty());
}

TEST_F(TroubleMessages, WhatIsNoMessageOfTheChannelIsNotObserved) {
  EXPECT_THAT(hear("STEREO_FRAME", stream<BaseStatus>()), HasSubstr("another type"));
  EXPECT_THAT(observe_message("STEREO_FRAME", "junk", 4, utime, now, troubles, state), HasSubstr("4 bytes"));
  EXPECT_THAT(observe_message("TASK_STATE", nullptr, 0, utime, now, troubles, state), HasSubstr("0 bytes"));
  EXPECT_TRUE(codes_after(10.0).empty());
}

TEST_F(TroubleMessages, AChannelOfNobodyTellsNothing) {
  EXPECT_EQ(hear("INVENTED", stream<BaseStatus>()), "");
  EXPECT_FALSE(state.base());
}

TEST_F(TroubleMessages, OfAPictureOnlyItsHeadIsRead) {
  EXPECT_EQ(hear("STEREO_FRAME", stream<StereoFrame>()), "");
  EXPECT_EQ(codes_after(3.0), std::vector<TroubleCode>{TroubleCode::kCameraSilent});
}

TEST_F(TroubleMessages, ADevicesStopIsItsOwn) {
  auto stop = stream<StopState>();
  stop.device = "arm";
  stop.latched = 1;
  stop.request_session = 9;
  stop.reason = "operator: asked";
  EXPECT_EQ(hear("STOP_STATE", stop), "");
  const std::vector<Trouble> told = troubles.step(now);
  ASSERT_EQ(told.size(), 1U);
  EXPECT_EQ(told[0].text, "stopped: operator: asked");
}

TEST_F(TroubleMessages, AProcessAndAServiceTell) {
  auto process = stream<ProcessStatus>();
  process.name = "mark-detector";
  process.host = "host";
  process.state = ProcessStatus::FAILED;
  EXPECT_EQ(hear("PROCESS_STATUS", process), "");
  EXPECT_EQ(codes_after(1.0), std::vector<TroubleCode>{TroubleCode::kProcessDead});
}

// What a bus says of a sender whose clock is ahead.
class ComplainingHost final : public bus::SubscriptionHost {
 public:
  void note_traffic() override {}
  bool note_utime(std::int64_t /*utime*/) override { return true; }
  std::int64_t newest_utime() const override { return 0; }
  double ahead_of_clock(std::int64_t /*utime*/) const override { return 5.0; }
  void complain(const std::string& /*channel*/, const std::string& /*what*/) override {}
  bool replaying() const override { return false; }
};

TEST_F(TroubleMessages, AServiceThatRefusesTheFutureIsUnderstood) {
  ComplainingHost host;
  bus::TypedSubscription<BaseStatus> subscription(&host, "r1/BASE_STATUS", bus::Delivery::kEach, true,
                                                  [](const BaseStatus&) {});
  const auto bytes = test::encoded(stream<BaseStatus>());
  subscription.receive(bytes.data(), bytes.size());
  auto service = stream<ServiceStatus>();
  service.name = "task-manager";
  service.state = "stale";
  service.reason = "r1/BASE_STATUS: all refused: " + subscription.refusal();
  EXPECT_EQ(hear("SERVICE_STATUS", service), "");
  const std::vector<Trouble> told = troubles.step(now);
  ASSERT_EQ(told.size(), 1U);
  EXPECT_EQ(told[0].code, TroubleCode::kClockAhead);
  EXPECT_EQ(told[0].subject, "BASE_STATUS");
}

}  // namespace
}  // namespace markservo::mmi
