#include "common/motion/command_sender.hpp"

#include <gtest/gtest.h>

namespace markservo::motion {
namespace {

TEST(CommandSender, AResetCarriesTheNewestStopStatesTimeOnceAllDevicesAreHeard) {
  CommandSender sender({"arm", "base"});
  EXPECT_FALSE(sender.stamp(CommandKind::kReset));
  sender.observe_stop_state("arm", 1000);
  EXPECT_FALSE(sender.stamp(CommandKind::kReset));
  EXPECT_EQ(sender.silent_devices(), std::vector<std::string>{"base"});
  sender.observe_stop_state("base", 1010);
  EXPECT_EQ(sender.stamp(CommandKind::kReset), 1010);
  sender.observe_stop_state("arm", 1200);
  EXPECT_EQ(sender.stamp(CommandKind::kReset), 1200) << "each repeat is stamped anew";
}

TEST(CommandSender, StartAndHomeCarryTheTasksTime) {
  CommandSender sender({"arm"});
  sender.observe_stop_state("arm", 1000);
  EXPECT_FALSE(sender.stamp(CommandKind::kStart));
  sender.observe_task_state(900);
  EXPECT_EQ(sender.stamp(CommandKind::kStart), 900);
  EXPECT_EQ(sender.stamp(CommandKind::kHome), 900);
}

TEST(CommandSender, StopAndAbortWaitForNobody) {
  const CommandSender sender({"arm"});
  EXPECT_EQ(sender.stamp(CommandKind::kStop), 0);
  EXPECT_EQ(sender.stamp(CommandKind::kAbort), 0);
}

}  // namespace
}  // namespace markservo::motion
