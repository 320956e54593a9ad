// Whose report of the arm a step is told of.

#include "services/task-manager/inputs/next_input.hpp"

#include <gtest/gtest.h>

#include <cstdint>

namespace markservo::task_manager {
namespace {

constexpr std::int64_t kFormer = 7;
constexpr std::int64_t kNext = 8;

ArmReport arm_of(std::int64_t session) {
  ArmReport report;
  report.session = session;
  return report;
}

Input taken(NextInput& next) {
  return next.take(ServoReport(), StopReport(), 0, 0);
}

TEST(NextInput, TellsOfTheNextArmWhatItSaidAsAStranger) {
  for (const bool told : {false, true}) {
    NextInput next;
    next.observe(arm_of(kFormer));
    next.observe_stranger(arm_of(kNext));
    EXPECT_EQ(taken(next).arm->session, kFormer);
    next.replace_arm(kNext, told);
    ASSERT_TRUE(taken(next).arm);
    EXPECT_EQ(taken(next).arm->session, kNext);
  }
}

TEST(NextInput, KeepsTheFormerArmsWordOnlyWhereSomethingWasToldByIt) {
  for (const bool told : {false, true}) {
    NextInput next;
    next.observe(arm_of(kFormer));
    next.replace_arm(kNext, told);
    EXPECT_EQ(taken(next).arm.has_value(), told);
  }
}

}  // namespace
}  // namespace markservo::task_manager
