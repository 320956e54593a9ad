#include "tests/experiments/demo_watches.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <markservo/TaskState.hpp>

namespace markservo::experiments {
namespace {

constexpr double kSpacing = 0.05;  // m

SimBody standing_at(double x) {
  SimBody body{};
  body.name = "red_book";
  body.p_CB.x = x;
  body.q_CB_w = std::sqrt(0.5);  // a body's z need not point up
  body.q_CB_x = std::sqrt(0.5);
  return body;
}

SimTruth truth_at(std::int64_t utime, bool held) {
  SimBody body = standing_at(0.0);
  body.height_gain = held ? 0.03 : 0.0;
  body.touches_left_finger = body.touches_right_finger = held ? 1 : 0;
  SimTruth truth{};
  truth.utime = utime;
  truth.num_bodies = 1;
  truth.bodies = {body};
  return truth;
}

TEST(CarriedBook, stands_elsewhere_when_released_still_upright_and_away) {
  const auto book = judge_carried(standing_at(0.0), standing_at(-0.3), standing_at(-0.3), kSpacing);
  EXPECT_TRUE(book.stands_elsewhere);
  EXPECT_NEAR(book.displacement, 0.3, 1e-9);
}

TEST(CarriedBook, is_not_carried_on_its_old_place) {
  EXPECT_FALSE(judge_carried(standing_at(0.0), standing_at(0.01), standing_at(0.01), kSpacing).stands_elsewhere);
}

TEST(CarriedBook, is_not_carried_while_a_finger_touches_it) {
  SimBody last = standing_at(-0.3);
  last.touches_left_finger = 1;
  EXPECT_FALSE(judge_carried(standing_at(0.0), standing_at(-0.3), last, kSpacing).stands_elsewhere);
}

TEST(CarriedBook, is_not_carried_while_it_moves) {
  EXPECT_FALSE(judge_carried(standing_at(0.0), standing_at(-0.29), standing_at(-0.3), kSpacing).stands_elsewhere);
}

TEST(CarriedBook, is_not_carried_when_it_lies) {
  SimBody last = standing_at(-0.3);
  last.q_CB_w = 1.0;
  last.q_CB_x = 0.0;
  const auto book = judge_carried(standing_at(0.0), last, last, kSpacing);
  EXPECT_NEAR(book.tilt_deg, 90.0, 1e-6);
  EXPECT_FALSE(book.stands_elsewhere);
}

TEST(LiftWatch, counts_without_a_break_from_the_end_of_the_lift) {
  LiftWatch watch;
  watch.observe(truth_at(0, true), "red_book", TaskState::LIFT_ON);
  watch.observe(truth_at(1'000'000, true), "red_book", TaskState::CARRY);
  watch.observe(truth_at(1'500'000, true), "red_book", TaskState::CARRY);
  watch.observe(truth_at(1'600'000, false), "red_book", TaskState::CARRY);
  watch.observe(truth_at(4'000'000, true), "red_book", TaskState::CARRY);
  EXPECT_NEAR(watch.held(), 0.5, 1e-9);
}

TEST(LiftWatch, does_not_count_once_the_book_is_let_go) {
  LiftWatch watch;
  watch.observe(truth_at(0, true), "red_book", TaskState::CARRY);
  watch.observe(truth_at(400'000, true), "red_book", TaskState::RELEASE);
  watch.observe(truth_at(900'000, true), "red_book", TaskState::HOLD_LIFTED);
  EXPECT_NEAR(watch.held(), 0.0, 1e-9);
}

TEST(LiftWatch, counts_another_attempt_alone) {
  LiftWatch watch;
  watch.observe(truth_at(0, false), "red_book", TaskState::CARRY);
  watch.observe(truth_at(1'000'000, false), "red_book", TaskState::LIFT);
  watch.observe(truth_at(2'000'000, true), "red_book", TaskState::HOLD_LIFTED);
  watch.observe(truth_at(3'000'000, true), "red_book", TaskState::HOLD_LIFTED);
  EXPECT_NEAR(watch.held(), 1.0, 1e-9);
}

}  // namespace
}  // namespace markservo::experiments
