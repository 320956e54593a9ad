#include "common/bus/sequence_monitor.hpp"

#include <gtest/gtest.h>

#include <initializer_list>

namespace markservo::bus {
namespace {

int64_t lost(std::initializer_list<int64_t> numbers) {
  SequenceMonitor monitor;
  for (const int64_t seq : numbers) monitor.observe(7, seq);
  return monitor.lost();
}

TEST(SequenceMonitor, CountsGaps) {
  EXPECT_EQ(lost({1, 2, 5, 6, 10}), 5);
  EXPECT_EQ(lost({10, 9, 11, 9, 12}), 0) << "late or twice";
}

TEST(SequenceMonitor, CountsALongGapOnceTheNextGoesOnFromIt) {
  EXPECT_EQ(lost({1, 2, 5000}), 0);
  EXPECT_EQ(lost({1, 2, 5000, 5001}), 4997);
  EXPECT_EQ(lost({1, 2, 5000, 5003}), 4999);
  EXPECT_EQ(lost({1, 2, 5000, 5001, 5003}), 4998);
}

TEST(SequenceMonitor, IsNotSpoiltByANumberThatLies) {
  constexpr int64_t kMost = int64_t{1} << 53;
  EXPECT_EQ(lost({1, 2, kMost, 3, 4, 6}), 1);
  EXPECT_EQ(lost({5000, 5001, 0, 5002, 5004}), 1);
  EXPECT_EQ(lost({1, kMost, 2, kMost, 3, kMost, 4}), 0) << "again and again";
}

TEST(SequenceMonitor, CountsNoMoreThanCanBe) {
  constexpr int64_t kMost = int64_t{1} << 53;
  EXPECT_LE(lost({0, kMost - 1, kMost}), kMaxLost);
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
