#include "common/bus/log_format.hpp"

#include <gtest/gtest.h>
#include <spdlog/spdlog.h>

#include <algorithm>

namespace markservo::bus {
namespace {

TEST(Log, LineOfATextFromTheBusStaysOneLine) {
  testing::internal::CaptureStderr();
  set_up_log("test", "info");
  spdlog::warn("STOP: {}", "reason\n12:00:00.000 simulator info released\x1b[31m\x07");
  spdlog::default_logger()->flush();
  const std::string logged = testing::internal::GetCapturedStderr();
  EXPECT_EQ(std::count(logged.begin(), logged.end(), '\n'), 1);
  EXPECT_NE(logged.find("test warning STOP: reason\\n12:00:00.000 simulator info released\\x1b[31m\\x07\n"),
            std::string::npos)
      << logged;
}

}  // namespace
}  // namespace markservo::bus
