#include "tests/experiments/touch_watch.hpp"

#include <gtest/gtest.h>

#include <markservo/TaskState.hpp>

namespace markservo::experiments {
namespace {

SimTruth truth_at(std::int64_t utime, const std::string& touched) {
  SimTruth truth{};
  truth.utime = utime;
  truth.arm_touched = touched.empty() ? 0 : 1;
  truth.touched = touched;
  return truth;
}

TEST(TouchWatch, knows_of_nothing_while_nothing_is_touched) {
  TouchWatch watch;
  watch.observe(truth_at(0, ""), TaskState::SERVO);
  EXPECT_EQ(watch.touched(), "");
  EXPECT_FALSE(watch.phase());
}

TEST(TouchWatch, keeps_the_first_pair_and_its_phase) {
  TouchWatch watch;
  watch.observe(truth_at(0, ""), TaskState::APPROACH);
  watch.observe(truth_at(1'000'000, "link_2 - shelf"), TaskState::SERVO);
  watch.observe(truth_at(1'400'000, "link_2 - shelf"), TaskState::GRIP);
  EXPECT_EQ(watch.touched(), "link_2 - shelf");
  EXPECT_EQ(watch.phase(), TaskState::SERVO);
}

TEST(TouchWatch, waits_for_a_phase_whose_message_was_lost) {
  TouchWatch watch;
  watch.observe(truth_at(1'000'000, "finger_left - book_middle"), TaskState::SERVO);
  watch.observe(truth_at(1'200'000, "finger_left - book_middle"), TaskState::GRIP);
  EXPECT_EQ(watch.phase(), TaskState::GRIP);
}

}  // namespace
}  // namespace markservo::experiments
