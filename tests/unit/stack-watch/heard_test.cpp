#include "services/stack-watch/heard.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>

namespace markservo::stack_watch {
namespace {

constexpr std::int64_t kSecond_us = 1'000'000;

Instant at(std::int64_t seconds) {
  return {1'700'000'000 * kSecond_us + seconds * kSecond_us, 50 * kSecond_us + seconds * kSecond_us};
}

census::ServiceWord word(const std::string& state, Instant now, int pid = 7) {
  census::ServiceWord word;
  word.name = "visual-servo";
  word.host = "here";
  word.pid = pid;
  word.session = 100 + pid;
  word.state = state;
  word.utime = now.wall_us;
  return word;
}

TEST(RecentCensus, TellsRatesOverFiveToTenSeconds) {
  RecentCensus recent(at(0));
  for (int second = 0; second < 100; ++second) {
    for (int i = 0; i < (second < 50 ? 2 : 30); ++i) {
      census::Heard message;
      message.channel = "POSE";
      message.utime = at(second).wall_us + i * kSecond_us / (second < 50 ? 2 : 30);
      recent.observe(message);
    }
    recent.step(at(second + 1));
  }
  const census::Report report = recent.report(at(100));
  EXPECT_GE(report.listened_s, 5.0);
  EXPECT_LE(report.listened_s, 10.0);
  EXPECT_NEAR(report.channels.at(0).hz, 30.0, 0.1) << "what was half a minute ago does not count";
}

TEST(RecentCensus, KnowsSinceWhenAServiceIsAsItIs) {
  RecentCensus recent(at(0));
  for (int second = 0; second < 60; ++second) {
    recent.observe(word(second < 40 ? "ready" : "stale", at(second)), at(second));
    recent.step(at(second));
  }
  EXPECT_EQ(recent.state_since_us(word("stale", at(60))), at(40).wall_us);
  EXPECT_EQ(recent.state_since_us(word("ready", at(60), 8)), std::nullopt);
}

TEST(RecentCensus, ForgetsWhoIsGone) {
  RecentCensus recent(at(0));
  recent.observe(word("ready", at(0)), at(0));
  for (int second = 1; second < 11; ++second) recent.step(at(second));
  EXPECT_TRUE(recent.report(at(11)).services.empty());
  for (int second = 11; second < 80; ++second) recent.step(at(second));
  EXPECT_EQ(recent.state_since_us(word("ready", at(0))), std::nullopt);
}

TEST(RecentCensus, TakesNoMoreThanSoMuchOfAHostileWriter) {
  RecentCensus recent(at(0));
  for (int pid = 0; pid < 20'000; ++pid) recent.observe(word("ready", at(0), pid), at(0));
  EXPECT_LE(recent.report(at(1)).services.size(), 1024U);
}

TEST(RecentCensus, HasRoomForWhatTheSupervisorRunsInAFlood) {
  RecentCensus recent(at(0));
  recent.observe({"here", {{"visual-servo", 7}}});
  const auto flood = [&recent](int second) {
    for (int i = 0; i < 6'000; ++i) {
      recent.observe(word("ready", at(second), 1000 + i), at(second));
      census::Heard message;
      message.channel = "FLOOD_" + std::to_string(i);
      message.utime = at(second).wall_us;
      message.session = 5000 + i;
      recent.observe(message);
    }
  };
  for (int second = 0; second < 20; ++second) {
    flood(second);
    recent.observe(word("ready", at(second)), at(second));
    census::Heard message;
    message.channel = "SERVO_STATUS";
    message.utime = at(second).wall_us;
    message.session = 107;
    recent.observe(message);
    recent.step(at(second));
  }
  const census::Report report = recent.report(at(20));
  const auto own = std::find_if(report.services.begin(), report.services.end(),
                                [](const census::ServiceReport& service) { return service.newest.pid == 7; });
  ASSERT_NE(own, report.services.end());
  EXPECT_EQ(own->writes, std::vector<std::string>{"SERVO_STATUS"});
  EXPECT_EQ(recent.state_since_us(word("ready", at(20))), at(0).wall_us);
}

}  // namespace
}  // namespace markservo::stack_watch
