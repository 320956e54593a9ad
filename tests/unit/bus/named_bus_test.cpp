#include "common/bus/named_bus.hpp"

#include <gtest/gtest.h>

#include "common/bus/bus_url.hpp"
#include "common/bus/command_line.hpp"
#include "tests/unit/bus/environment_variable.hpp"

namespace markservo::bus {
namespace {

using test::EnvironmentVariable;

constexpr const char* kOne = "udpm://239.255.76.67:7001?ttl=0";
constexpr const char* kOther = "udpm://239.255.76.67:7002?ttl=0";

class NamedBusTest : public ::testing::Test {
 protected:
  // The bus that a program with these words takes.
  static std::string taken(std::vector<const char*> words) {
    words.insert(words.begin(), "program");
    CommandLine command_line("program", "A test");
    std::string url = kDefaultUrl;
    add_lcm_url(Options(command_line.app()), url, "The bus");
    EXPECT_FALSE(command_line.parse(static_cast<int>(words.size()), words.data()));
    return url;
  }

  EnvironmentVariable ours_{"MARKSERVO_LCM_URL", std::nullopt};
  EnvironmentVariable of_lcm_{"LCM_DEFAULT_URL", std::nullopt};
};

TEST_F(NamedBusTest, IsNoneWhereTheEnvironmentSaysNothing) {
  EXPECT_FALSE(named_bus());
  EXPECT_EQ(taken({}), kDefaultUrl);
}

TEST_F(NamedBusTest, OfLcmsOwnVariableIsOursToo) {
  const EnvironmentVariable of_lcm("LCM_DEFAULT_URL", kOne);
  EXPECT_EQ(taken({}), kOne);
}

TEST_F(NamedBusTest, OfOurVariableCountsBeforeLcms) {
  const EnvironmentVariable of_lcm("LCM_DEFAULT_URL", kOne);
  const EnvironmentVariable ours("MARKSERVO_LCM_URL", kOther);
  EXPECT_EQ(taken({}), kOther);
}

TEST_F(NamedBusTest, IsNoneByAnEmptyVariable) {
  const EnvironmentVariable ours("MARKSERVO_LCM_URL", "");
  const EnvironmentVariable empty("LCM_DEFAULT_URL", "");
  EXPECT_EQ(taken({}), kDefaultUrl);
  const EnvironmentVariable of_lcm("LCM_DEFAULT_URL", kOne);
  EXPECT_EQ(taken({}), kOne);
}

TEST_F(NamedBusTest, OfTheCommandLineCountsFirst) {
  const EnvironmentVariable of_lcm("LCM_DEFAULT_URL", kOne);
  EXPECT_EQ(taken({"--lcm-url", kOther}), kOther);
}

TEST_F(NamedBusTest, IsToldWhereLcmsVariableNamesIt) {
  EXPECT_EQ(told_by(kOne), "");
  const EnvironmentVariable of_lcm("LCM_DEFAULT_URL", kOne);
  EXPECT_EQ(told_by(std::string("bus ") + kOne + ": cannot be joined"), " (the bus that LCM_DEFAULT_URL names)");
  EXPECT_EQ(told_by(kOther), "");
  EXPECT_EQ(told_by(std::string(kOne) + "&recv_buf_size=4194304"), "");
  const EnvironmentVariable ours("MARKSERVO_LCM_URL", kOne);
  EXPECT_EQ(told_by(kOne), "");
}

}  // namespace
}  // namespace markservo::bus
