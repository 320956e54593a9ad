#include "common/bus/sequence_monitor.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <initializer_list>
#include <limits>

namespace markservo::bus {
namespace {

std::int64_t lost(std::initializer_list<std::int64_t> numbers) {
  SequenceMonitor monitor;
  for (const std::int64_t seq : numbers) monitor.observe(7, seq);
  return monitor.lost();
}

TEST(SequenceMonitor, CountsAGapOnceTheNextGoesOnFromIt) {
  EXPECT_EQ(lost({1, 2, 5}), 0);
  EXPECT_EQ(lost({1, 2, 5, 6}), 2);
  EXPECT_EQ(lost({1, 2, 5, 6, 10, 11}), 5);
  EXPECT_EQ(lost({1, 3, 5, 7, 9, 10}), 4) << "every other one";
  EXPECT_EQ(lost({1, 2, 5000}), 0);
  EXPECT_EQ(lost({1, 2, 5000, 5001}), 4997);
  EXPECT_EQ(lost({1, 2, 5000, 5003, 5004}), 4999);
}

TEST(SequenceMonitor, LosesNothingByOneThatComesLateOrTwiceOrBeforeItsTurn) {
  EXPECT_EQ(lost({10, 9, 11, 9, 12}), 0);
  EXPECT_EQ(lost({1, 2, 4, 3, 5, 6}), 0);
  EXPECT_EQ(lost({1, 4, 2, 3, 5, 6}), 0) << "by two";
  EXPECT_EQ(lost({1, 2, 4, 2, 5}), 1) << "one that comes again denies nothing";
}

TEST(SequenceMonitor, IsNotSpoiltByANumberThatLies) {
  EXPECT_EQ(lost({1, 2, kMaxLost, 3, 4, 6, 7}), 1);
  EXPECT_EQ(lost({1, 2, 102, 3, 4, 6, 7}), 1) << "a lie that is near";
  EXPECT_EQ(lost({1, 2, 102, 4, 5, 7, 8}), 2) << "right before a loss";
  EXPECT_EQ(lost({5000, 5001, 0, 5002, 5004, 5005}), 1);
  EXPECT_EQ(lost({1, kMaxLost, 2, kMaxLost, 3, kMaxLost, 4}), 0) << "again and again";
}

TEST(SequenceMonitor, CountsSoMuchForTwoNumbersThatLieAndGoesOn) {
  EXPECT_EQ(lost({1, 2, kMaxLost - 1, kMaxLost}), 10'000);
  EXPECT_EQ(lost({1, 2, kMaxLost - 1, kMaxLost, 3, 4, 6, 7}), 10'001);
  EXPECT_EQ(lost({1, std::numeric_limits<std::int64_t>::max(), std::numeric_limits<std::int64_t>::min(), 2, 3}), 0);
}

TEST(SequenceMonitor, AddsUpWhatWasLostInEachSession) {
  SequenceMonitor monitor;
  for (const std::int64_t session : {7, 8}) {
    for (const std::int64_t seq : {1, 3, 4}) monitor.observe(session, seq);
  }
  EXPECT_EQ(monitor.lost(), 2);
}

TEST(SequenceMonitor, ForgetsASecondWriterOnceOneAloneHasSentLongEnough) {
  SequenceMonitor monitor;
  monitor.observe(1, 1);
  monitor.observe(2, 1);
  monitor.observe(1, 2);
  EXPECT_TRUE(monitor.second_writer());
  for (int seq = 3; seq < 502; ++seq) monitor.observe(1, seq);
  EXPECT_TRUE(monitor.second_writer());
  monitor.observe(1, 502);
  EXPECT_FALSE(monitor.second_writer());
}

}  // namespace
}  // namespace markservo::bus
