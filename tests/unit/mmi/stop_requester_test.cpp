#include "services/mmi/stop/stop_requester.hpp"

#include <gtest/gtest.h>

#include "services/mmi/stop/stop_json.hpp"

namespace markservo::mmi {
namespace {

constexpr std::int64_t kSecond_us = 1'000'000;

// A requester with two stop devices that have spoken, at 100 s of their time.
class Stop : public ::testing::Test {
 protected:
  Stop() {
    hear("arm", false, false, 100 * kSecond_us, 0.0);
    hear("base", false, false, 100 * kSecond_us, 0.0);
  }

  void hear(const std::string& device, bool latched, bool answers_us, std::int64_t utime, double now) {
    stop.observe(task::StopReport{device, latched, answers_us, latched ? "page: asked" : ""}, utime, now);
  }
  void echo(const std::string& device, double now) {
    hear(device, true, true, 100 * kSecond_us + static_cast<std::int64_t>(1e6 * now), now);
  }
  StopAnswer state(double now) const { return stop.view(now).state; }
  StopAnswer answer(std::size_t device, double now) const { return stop.view(now).devices.at(device).answer; }

  StopRequester stop{{"arm", "base"}};
};

TEST_F(Stop, NothingIsSentBeforeSomebodyAsks) {
  EXPECT_FALSE(stop.due(0.0));
  EXPECT_EQ(state(0.0), StopAnswer::kIdle);
}

TEST_F(Stop, IsSentAtOnceAndEveryFifthOfASecondUntilEveryDeviceHasEchoed) {
  stop.request("asked", 1.0);
  const auto first = stop.due(1.0);
  ASSERT_TRUE(first);
  EXPECT_EQ(first->request_id, stop.request_id());
  EXPECT_EQ(first->utime, 100 * kSecond_us);
  EXPECT_EQ(first->reason, "asked");
  EXPECT_FALSE(stop.due(1.1));
  EXPECT_TRUE(stop.due(1.25));
  echo("arm", 1.3);
  EXPECT_EQ(state(1.3), StopAnswer::kRequested);
  EXPECT_EQ(answer(0, 1.3), StopAnswer::kAcknowledged);
  EXPECT_EQ(answer(1, 1.3), StopAnswer::kRequested);
  EXPECT_TRUE(stop.due(1.5));
  echo("base", 1.6);
  EXPECT_EQ(state(1.6), StopAnswer::kAcknowledged);
  EXPECT_FALSE(stop.due(1.7));
  EXPECT_FALSE(stop.due(100.0));
}

TEST_F(Stop, SeveralClicksAreOneRequest) {
  stop.request("first", 1.0);
  const auto id = stop.request_id();
  EXPECT_TRUE(stop.due(1.0));
  stop.request("second", 1.05);
  EXPECT_EQ(stop.request_id(), id);
  EXPECT_FALSE(stop.due(1.1));
  EXPECT_EQ(stop.due(1.25)->reason, "first");
}

TEST_F(Stop, AClickAfterTheAnswerIsAnotherRequest) {
  stop.request("first", 1.0);
  const auto id = stop.request_id();
  echo("arm", 1.1);
  echo("base", 1.1);
  stop.request("second", 5.0);
  EXPECT_NE(stop.request_id(), id);
  EXPECT_EQ(state(5.0), StopAnswer::kRequested);
  EXPECT_EQ(answer(0, 5.0), StopAnswer::kRequested);
  EXPECT_TRUE(stop.due(5.0));
}

TEST_F(Stop, ALatchThatAnswersAnotherIsNoEcho) {
  stop.request("asked", 1.0);
  hear("arm", true, false, 101 * kSecond_us, 1.1);
  hear("base", true, false, 101 * kSecond_us, 1.1);
  EXPECT_EQ(state(1.2), StopAnswer::kRequested);
  EXPECT_TRUE(stop.due(1.25));
}

TEST_F(Stop, AnEchoOfADeviceThatIsNotLatchedIsNone) {
  stop.request("asked", 1.0);
  hear("arm", false, true, 101 * kSecond_us, 1.1);
  echo("base", 1.1);
  EXPECT_EQ(state(1.2), StopAnswer::kRequested);
}

TEST_F(Stop, AnothersLaterStopDoesNotTakeTheEchoBack) {
  stop.request("asked", 1.0);
  echo("arm", 1.1);
  hear("arm", true, false, 102 * kSecond_us, 1.2);
  echo("base", 1.3);
  EXPECT_EQ(state(1.3), StopAnswer::kAcknowledged);
}

TEST_F(Stop, ADeviceWithoutAnEchoIsSilentSoonWhetherItSpeaksOrNot) {
  stop.request("asked", 1.0);
  stop.due(1.0);
  echo("arm", 1.1);
  hear("base", false, false, 101 * kSecond_us, 1.2);
  EXPECT_EQ(answer(1, 1.31), StopAnswer::kRequested);
  EXPECT_EQ(answer(1, 1.33), StopAnswer::kSilent);
  EXPECT_EQ(state(1.5), StopAnswer::kRequested);
  EXPECT_TRUE(stop.due(1.5));
  echo("base", 9.0);
  EXPECT_EQ(answer(1, 9.0), StopAnswer::kAcknowledged);
  EXPECT_EQ(state(9.0), StopAnswer::kAcknowledged);
}

TEST_F(Stop, WhatNobodyAsksAndNobodyHearsIsSilentToo) {
  EXPECT_EQ(answer(0, 0.5), StopAnswer::kIdle);
  EXPECT_EQ(answer(0, 3.0), StopAnswer::kSilent);
  EXPECT_EQ(StopRequester({"arm"}).view(0.0).devices[0].answer, StopAnswer::kSilent);
  EXPECT_EQ(StopRequester({"arm"}).view(0.0).devices[0].latched, std::nullopt);
}

TEST_F(Stop, GoesOnForTheOthersWhereOneThatHasEchoedBeginsAnew) {
  stop.request("asked", 1.0);
  stop.due(1.0);
  echo("arm", 1.1);
  hear("arm", false, false, 103 * kSecond_us, 1.2);
  EXPECT_EQ(state(1.2), StopAnswer::kRequested);
  EXPECT_TRUE(stop.due(1.25));
  echo("base", 1.3);
  EXPECT_EQ(state(1.3), StopAnswer::kRequested) << "the arm is free";
}

TEST_F(Stop, ALateWordOfADeviceMakesNoEarlierResetALaterOne) {
  stop.request("asked", 1.0);
  stop.due(1.0);
  hear("base", false, false, 100 * kSecond_us - 200'000, 1.1);
  stop.observe(HeardReset{55, 1, 100 * kSecond_us - 100'000});
  EXPECT_TRUE(stop.due(1.25));
}

TEST_F(Stop, IsNotSentAgainAfterALaterReset) {
  stop.request("asked", 1.0);
  EXPECT_TRUE(stop.due(1.0));
  echo("arm", 1.1);
  stop.observe(HeardReset{55, 1, 101 * kSecond_us});
  EXPECT_EQ(state(1.2), StopAnswer::kIdle);
  EXPECT_FALSE(stop.due(1.25));
  EXPECT_FALSE(stop.due(60.0));
}

TEST_F(Stop, AResetOfBeforeItDoesNotEndIt) {
  stop.request("asked", 1.0);
  stop.due(1.0);
  stop.observe(HeardReset{55, 1, 100 * kSecond_us});
  EXPECT_TRUE(stop.due(1.25));
}

TEST_F(Stop, ARepeatOfAResetThatWasHeardBeforeItDoesNotEndItHoweverItIsStamped) {
  stop.observe(HeardReset{55, 1, 100 * kSecond_us});
  stop.request("asked", 1.0);
  stop.due(1.0);
  stop.observe(HeardReset{55, 1, 103 * kSecond_us});
  EXPECT_TRUE(stop.due(1.25));
  stop.observe(HeardReset{55, 2, 103 * kSecond_us});
  EXPECT_FALSE(stop.due(1.5));
}

TEST_F(Stop, ADeviceThatIsReleasedOnceAllHaveEchoedShowsThatSomebodyHasResetIt) {
  stop.request("asked", 1.0);
  stop.due(1.0);
  echo("arm", 1.1);
  echo("base", 1.1);
  hear("arm", false, false, 103 * kSecond_us, 3.0);
  EXPECT_EQ(state(3.0), StopAnswer::kIdle);
  EXPECT_FALSE(stop.due(3.0));
}

TEST_F(Stop, AWordOfBeforeTheEchoThatComesLateDoesNotEndIt) {
  stop.request("asked", 1.0);
  stop.due(1.0);
  echo("arm", 1.1);
  hear("arm", false, false, 100 * kSecond_us, 1.15);
  EXPECT_TRUE(stop.due(1.25));
}

TEST_F(Stop, AResetCountsInTheDevicesTimeThoughThatBeganAnew) {
  stop.request("asked", 1.0);
  stop.due(1.0);
  hear("arm", true, false, 2 * kSecond_us, 1.1);
  stop.observe(HeardReset{55, 1, 3 * kSecond_us});
  EXPECT_FALSE(stop.due(1.25));
}

TEST_F(Stop, AfterAnAnswerAResetMakesItIdle) {
  stop.request("asked", 1.0);
  echo("arm", 1.1);
  echo("base", 1.1);
  stop.observe(HeardReset{55, 1, 105 * kSecond_us});
  EXPECT_EQ(state(6.0), StopAnswer::kIdle);
}

TEST(StopBeforeAnyDeviceWasHeard, IsSentWithATimeThatIsUnknown) {
  StopRequester stop({"arm"});
  stop.request("asked", 1.0);
  EXPECT_EQ(stop.due(1.0)->utime, 0);
}

TEST_F(Stop, OnlyStopDevicesCount) {
  stop.request("asked", 1.0);
  echo("lift", 1.1);
  EXPECT_EQ(stop.view(1.1).devices.size(), 2U);
  EXPECT_EQ(state(1.1), StopAnswer::kRequested);
}

TEST_F(Stop, IsToldAsThePagesProtocolHasIt) {
  stop.request("asked", 1.0);
  echo("arm", 1.1);
  EXPECT_EQ(stop_json(stop.view(1.6)), nlohmann::ordered_json::parse(R"({
    "state": "requested", "request": "1", "devices": [
      {"device": "arm", "state": "acknowledged", "latched": true, "reason": "page: asked"},
      {"device": "base", "state": "silent", "latched": false, "reason": ""}]})"));
  EXPECT_EQ(
      stop_json(StopRequester({"arm"}).view(0.0)).dump(),
      R"({"state":"idle","request":"0","devices":[{"device":"arm","state":"silent","latched":null,"reason":""}]})");
}

}  // namespace
}  // namespace markservo::mmi
