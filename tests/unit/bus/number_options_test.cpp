#include "common/bus/number_options.hpp"

#include <gtest/gtest.h>

#include <CLI/CLI.hpp>

namespace markservo::bus {
namespace {

class Numbers : public testing::Test {
 protected:
  Numbers() {
    const NumberOptions number(app_);
    number("--gain", gain_, "A number", 0.05, 1.0);
  }
  std::string refusal(const std::string& value) {
    try {
      app_.parse("--gain " + value);
    } catch (const CLI::ValidationError& error) {
      return error.what();
    }
    return "";
  }
  CLI::App app_;
  double gain_ = 0.5;
};

TEST_F(Numbers, InTheirRangeAreTaken) {
  EXPECT_EQ(refusal("0.05"), "");
  EXPECT_EQ(gain_, 0.05);
}

TEST_F(Numbers, OutsideOrNoneAreRefusedWithWhatIsAllowed) {
  for (const char* value : {"nan", "-nan", "inf", "-inf", "1.01", "0", "much", "0.5m"}) {
    EXPECT_EQ(refusal(value), "--gain: '" + std::string(value) + "'; allowed: 0.05 to 1");
  }
}

}  // namespace
}  // namespace markservo::bus
