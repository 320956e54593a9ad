#include "services/task-manager/goal_numbers.hpp"

#include <gtest/gtest.h>

namespace markservo::task_manager {
namespace {

TEST(GoalNumbers, PassWhatAMoverReportsForHalfASecondAndNothingElse) {
  constexpr std::int64_t kForged = 1'000'003;
  GoalNumbers numbers;
  for (int i = 0; i < 60; ++i) numbers.observe(i % 2 == 0 ? kForged : 3, 33'000 * i);
  EXPECT_EQ(numbers.next(3), 4) << "a liar beside the mover";
  numbers.observe(kForged, 2'000'000);
  numbers.observe(kForged, 2'499'999);
  EXPECT_EQ(numbers.next(3), 4);
  numbers.observe(kForged, 2'500'000);
  EXPECT_EQ(numbers.next(3), kForged + 1);
}

}  // namespace
}  // namespace markservo::task_manager
