// What is told of all stop devices together.

#include "services/task-manager/inputs/stop_devices.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <string>

namespace markservo::task_manager {
namespace {

constexpr std::int64_t kNow = 100'000'000;  // us

class TwoStopDevices : public ::testing::Test {
 protected:
  void tell(const std::string& device, bool latched, std::int64_t utime) {
    devices_.hear_stop_state(device, {7, ++seq_, utime}, latched, "why");
  }

  StopDevices devices_{{"arm", "base"}};
  std::int64_t seq_ = 0;
};

TEST_F(TwoStopDevices, AreKnownWhenBothHaveSpokenWithinASecond) {
  EXPECT_EQ(devices_.report(kNow).silent, "arm, base");
  tell("arm", false, kNow);
  EXPECT_FALSE(devices_.report(kNow).known);
  EXPECT_EQ(devices_.report(kNow).silent, "base");
  tell("base", false, kNow);
  EXPECT_TRUE(devices_.report(kNow + 1'000'000).known);
  EXPECT_FALSE(devices_.report(kNow + 1'000'001).known);
}

TEST_F(TwoStopDevices, AreLatchedWhenOneIs) {
  tell("arm", false, kNow);
  tell("base", true, kNow);
  EXPECT_TRUE(devices_.report(kNow).latched);
  EXPECT_EQ(devices_.report(kNow).reason, "base: why");
}

TEST_F(TwoStopDevices, TellOnceOfAStopThatIsResetByNow) {
  tell("arm", true, kNow);
  tell("arm", false, kNow + 1);
  const StopReport report = devices_.report(kNow + 1);
  EXPECT_FALSE(report.latched);
  EXPECT_TRUE(report.meanwhile);
  EXPECT_FALSE(devices_.report(kNow + 1).meanwhile);
}

}  // namespace
}  // namespace markservo::task_manager
