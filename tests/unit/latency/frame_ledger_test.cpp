#include "tests/bench/latency/frame_ledger.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

namespace markservo::bench {
namespace {

using Seconds = std::vector<double>;

TEST(FrameLedger, latency_lies_between_the_frame_and_its_last_message) {
  FrameLedger ledger(2);
  ledger.sent(1, 10.0);
  EXPECT_FALSE(ledger.came_in(0, 1, 10.25));
  EXPECT_TRUE(ledger.came_in(1, 1, 10.75));
  EXPECT_EQ(ledger.latencies(), Seconds{0.75});
}

TEST(FrameLedger, hops_add_up_to_the_latency) {
  FrameLedger ledger(2);
  ledger.sent(1, 10.0);
  ledger.came_in(0, 1, 10.25);
  ledger.came_in(1, 1, 10.75);
  EXPECT_EQ(ledger.hops(0), Seconds{0.25});
  EXPECT_EQ(ledger.hops(1), Seconds{0.5});
}

TEST(FrameLedger, frames_that_overlap_keep_their_own_times) {
  FrameLedger ledger(1);
  ledger.sent(1, 10.0);
  ledger.sent(2, 11.0);
  ledger.came_in(0, 2, 11.5);
  ledger.came_in(0, 1, 12.0);
  EXPECT_EQ(ledger.latencies(), (Seconds{2.0, 0.5}));
}

TEST(FrameLedger, a_frame_without_its_last_message_is_lost) {
  FrameLedger ledger(2);
  ledger.sent(1, 10.0);
  ledger.sent(2, 11.0);
  ledger.came_in(0, 1, 10.5);
  ledger.came_in(1, 2, 11.5);
  EXPECT_EQ(ledger.num_sent(), 2U);
  EXPECT_EQ(ledger.num_lost(), 1U);
}

TEST(FrameLedger, the_first_of_two_answers_counts) {
  FrameLedger ledger(1);
  ledger.sent(1, 10.0);
  EXPECT_TRUE(ledger.came_in(0, 1, 10.5));
  EXPECT_FALSE(ledger.came_in(0, 1, 11.5));
  EXPECT_EQ(ledger.latencies(), Seconds{0.5});
}

TEST(FrameLedger, what_answers_no_frame_of_it_does_not_count) {
  FrameLedger ledger(1);
  ledger.sent(1, 10.0);
  EXPECT_FALSE(ledger.came_in(0, 7, 10.5));
  EXPECT_EQ(ledger.num_sent(), 1U);
  EXPECT_TRUE(ledger.latencies().empty());
}

TEST(FrameLedger, needs_a_stage) {
  EXPECT_THROW(FrameLedger(0), std::invalid_argument);
  FrameLedger ledger(1);
  ledger.sent(1, 10.0);
  EXPECT_THROW(ledger.came_in(1, 1, 10.5), std::out_of_range);
}

}  // namespace
}  // namespace markservo::bench
