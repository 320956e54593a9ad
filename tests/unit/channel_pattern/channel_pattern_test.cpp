#include "common/channel_pattern/channel_pattern.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

namespace markservo {
namespace {

bool takes(const std::string& pattern, const std::string& name) {
  return ChannelPattern(pattern).matches(name);
}

std::string complaint(const std::string& pattern) {
  try {
    ChannelPattern{pattern};
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return {};
}

TEST(ChannelPattern, IsAPerlCompatibleExpressionAsLiblcmsToolsHaveIt) {
  EXPECT_TRUE(takes("CAM\\d", "CAM1"));
  EXPECT_FALSE(takes("CAM\\d", "CAMd"));
  EXPECT_TRUE(takes("(?!STEREO_FRAME).*", "TARGET_POSE"));
  EXPECT_FALSE(takes("(?!STEREO_FRAME).*", "STEREO_FRAME"));
  EXPECT_TRUE(takes("[[:upper:]]+", "STOP")) << "POSIX classes too";
}

TEST(ChannelPattern, TakesWholeNamesOnly) {
  for (const char* pattern : {"A", "A|BC"}) {
    EXPECT_TRUE(takes(pattern, "A")) << pattern;
    EXPECT_FALSE(takes(pattern, "AB")) << pattern;
    EXPECT_FALSE(takes(pattern, "r/A")) << pattern;
    EXPECT_FALSE(takes(pattern, "A\n")) << pattern;
  }
  EXPECT_TRUE(takes("A|BC", "BC"));
  EXPECT_FALSE(takes("\\QA", "AB")) << "a quotation that is not ended";
  EXPECT_TRUE(takes("A1(*ACCEPT)", "A1"));
  EXPECT_FALSE(takes("A1(*ACCEPT)", "A10")) << "a match that ends itself early";
}

TEST(ChannelPattern, IsOneChannelWhereThatIsItsName) {
  const ChannelPattern named("A.B", {"A.B", "AXB"});
  EXPECT_TRUE(named.matches("A.B"));
  EXPECT_FALSE(named.matches("AXB"));
  EXPECT_TRUE(takes("A.B", "AXB")) << "a pattern, where no channel is called so";
  for (const char* name : {"P\\E|.*|\\Q", ".*", "(", "a+b"}) {
    const ChannelPattern pattern(name, {name});
    EXPECT_TRUE(pattern.matches(name)) << name;
    EXPECT_FALSE(pattern.matches("STOP")) << name;
    EXPECT_FALSE(pattern.takes_any_name()) << name;
  }
}

TEST(ChannelPattern, KnowsWhenItNamesNothing) {
  for (const char* pattern : {".*", ".+", "(?!STEREO_FRAME).*", "[^r].*", "\\w+", "\\S+", "[A-Z_]+", "[a-z0-9]+",
                              "(?!Z).*", "\\w+/\\w+", "(r1/)?[[:upper:]]+"}) {
    EXPECT_TRUE(ChannelPattern(pattern).takes_any_name()) << pattern;
  }
  for (const char* pattern : {"MOTOR.*", "MOTOR_\\w+", "CAM\\d", "r1/MOTOR_.*", "STOP", ""}) {
    EXPECT_FALSE(ChannelPattern(pattern).takes_any_name()) << pattern;
  }
}

TEST(ChannelPattern, TakesNamesOfAnyBytesButZero) {
  EXPECT_TRUE(takes("A.*", "A\xff\x1b"));
  EXPECT_FALSE(takes(".*", std::string("A\0B", 3)));
}

TEST(ChannelPattern, SaysWhatIsNone) {
  EXPECT_EQ(complaint("("),
            "channel pattern '(': missing terminating ); allowed: a channel's name, or a Perl-compatible regular "
            "expression of the whole name");
  EXPECT_NE(complaint("A)|(B").find("missing terminating )"), std::string::npos) << complaint("A)|(B");
  EXPECT_NE(complaint("A\\").find("allowed: a channel's name"), std::string::npos);
  EXPECT_NE(complaint(std::string("A\0B", 3)).find("zero byte"), std::string::npos);
}

TEST(ChannelPattern, SaysWhenItTakesTooLong) {
  const ChannelPattern endless("((a|aa)+)+");
  EXPECT_THROW(endless.matches(std::string(70, 'a') + "b"), std::invalid_argument);
  EXPECT_THROW(takes("([ab]+)+[^ab]", std::string(50, 'a')), std::invalid_argument);
}

}  // namespace
}  // namespace markservo
