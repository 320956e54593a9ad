#include "common/bus/channel_expressions.hpp"

#include <gtest/gtest.h>

#include "common/channel_pattern/channel_pattern.hpp"

namespace markservo::bus {
namespace {

bool matches(const std::string& channel, const std::string& expression) {
  return ChannelPattern(expression).matches(channel);  // by GLib's expressions, as liblcm
}

TEST(ChannelExpression, MatchesOneChannelWhateverItIsCalled) {
  for (const std::string channel : {"JOINT_STATE", "r.1/A", "arm+1/(A|B)[0]"}) {
    EXPECT_TRUE(matches(channel, expression_of(channel))) << channel;
  }
  EXPECT_FALSE(matches("rx1/A", expression_of("r.1/A")));
}

TEST(AllChannels, HoldEachChannelOnce) {
  const AllChannels all = all_channels("");
  for (const char* large : {"STEREO_FRAME", "r2/STEREO_FRAME", "lab/r2/MARK_DETECTION"}) {
    EXPECT_TRUE(matches(large, all.large)) << large;
    EXPECT_FALSE(matches(large, all.others)) << large;
  }
  for (const char* other : {"TASK_STATE", "r2/TASK_STATE", "STEREO_FRAME/A", "MY_STEREO_FRAME", "STEREO_FRAME2", ""}) {
    EXPECT_FALSE(matches(other, all.large)) << other;
    EXPECT_TRUE(matches(other, all.others)) << other;
  }
}

TEST(AllChannels, AreOneRobotsWhereItHasAName) {
  const AllChannels all = all_channels("r.1");
  EXPECT_TRUE(matches("r.1/STEREO_FRAME", all.large));
  EXPECT_TRUE(matches("r.1/TASK_STATE", all.others));
  for (const char* foreign : {"STEREO_FRAME", "TASK_STATE", "r2/STEREO_FRAME", "rx1/TASK_STATE"}) {
    EXPECT_FALSE(matches(foreign, all.large)) << foreign;
    EXPECT_FALSE(matches(foreign, all.others)) << foreign;
  }
}

}  // namespace
}  // namespace markservo::bus
