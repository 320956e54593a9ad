#include "services/recorder/folder/last_event.hpp"

#include <gtest/gtest.h>

#include <string>

namespace markservo::recorder {
namespace {

constexpr std::int64_t kNow = 1'700'000'000'000'000;
constexpr std::int64_t kSecond_us = 1'000'000;

std::string big_endian(std::uint64_t number) {
  std::string bytes;
  for (int shift = 56; shift >= 0; shift -= 8) bytes += static_cast<char>(number >> shift & 0xff);
  return bytes;
}

// As lcm-logger writes it, with a message of 40 bytes.
std::string event(std::int64_t number, std::int64_t utime) {
  return "\xED\xA1\xDA\x01" + big_endian(static_cast<std::uint64_t>(number)) +
         big_endian(static_cast<std::uint64_t>(utime)) + big_endian(std::uint64_t{4} << 32 | 40) + "POSE" +
         std::string(40, 'x');
}

TEST(LastEvent, IsTheOneThatBeginsLast) {
  const std::string log = event(1, kNow - 3 * kSecond_us) + event(2, kNow - 2 * kSecond_us);
  EXPECT_EQ(last_event_utime(log, kNow), kNow - 2 * kSecond_us);
  EXPECT_EQ(last_event_utime("torn" + log, kNow), kNow - 2 * kSecond_us);
}

TEST(LastEvent, IsTheOneBeforeWhereTheLastWasTornInItsHeader) {
  const std::string log = event(1, kNow - 3 * kSecond_us) + event(2, kNow - 2 * kSecond_us).substr(0, 19);
  EXPECT_EQ(last_event_utime(log, kNow), kNow - 3 * kSecond_us);
}

TEST(LastEvent, IsNotWhatLooksLikeOneWithinAPicture) {
  const std::string log = event(1, kNow - kSecond_us);
  EXPECT_EQ(last_event_utime(log + event(2, kNow + 1), kNow), kNow - kSecond_us);
  EXPECT_EQ(last_event_utime(log + event(2, kNow - 86'400 * kSecond_us), kNow), kNow - kSecond_us);
  EXPECT_EQ(last_event_utime(log + event(2, -5), kNow), kNow - kSecond_us);
}

TEST(LastEvent, IsNothingWhereThereIsNone) {
  EXPECT_EQ(last_event_utime("", kNow), std::nullopt);
  EXPECT_EQ(last_event_utime("\xED\xA1\xDA\x01", kNow), std::nullopt);
  EXPECT_EQ(last_event_utime(std::string(100'000, '\xED'), kNow), std::nullopt);
}

TEST(LastEvent, IsNotLookedForForever) {
  std::string log = event(1, kNow - kSecond_us);
  for (int i = 0; i < 99; ++i) log += event(2, kNow + 1);
  EXPECT_EQ(last_event_utime(log, kNow), kNow - kSecond_us);
  EXPECT_EQ(last_event_utime(log + event(2, kNow + 1), kNow), std::nullopt);
}

TEST(MissedSince, IsTheLastEventOfTheNewestPartThatHasOne) {
  EXPECT_EQ(missed_since({kNow}, kNow - kSecond_us), kNow);
  EXPECT_EQ(missed_since({kNow - 9 * kSecond_us, kNow}, kNow - kSecond_us), kNow)
      << "the newest holds an older logger's";
}

TEST(MissedSince, IsWhenTheLoggerBeganToListenWhereItHeardNothing) {
  EXPECT_EQ(missed_since({}, kNow), kNow);
  EXPECT_EQ(missed_since({kNow - kSecond_us}, kNow), kNow);
}

}  // namespace
}  // namespace markservo::recorder
