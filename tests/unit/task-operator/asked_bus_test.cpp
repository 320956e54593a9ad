#include "services/task-operator/asked_bus.hpp"

#include <gtest/gtest.h>

namespace markservo::task_operator {
namespace {

TEST(AskedBus, NamesWhoSpeaksThere) {
  EXPECT_EQ(told_of_bus("udpm://", {"simulator"}), "asked on udpm://, where simulator speaks");
  EXPECT_EQ(told_of_bus("udpm://", {"simulator", "mark-detector", "stack-watch"}),
            "asked on udpm://, where mark-detector, simulator and stack-watch speak");
}

TEST(AskedBus, NamesAFewOfMany) {
  EXPECT_EQ(told_of_bus("udpm://", {"a", "b", "c", "d"}), "asked on udpm://, where a, b, c and d speak");
  EXPECT_EQ(told_of_bus("udpm://", {"a", "b", "c", "d", "e"}), "asked on udpm://, where a, b, c and 2 more speak");
}

TEST(AskedBus, WhereNobodySpeaksMayBeAnother) {
  EXPECT_EQ(told_of_bus("udpm://", {}),
            "asked on udpm://, where no service speaks: is it another bus (--lcm-url) or robot (--robot)?");
}

}  // namespace
}  // namespace markservo::task_operator
