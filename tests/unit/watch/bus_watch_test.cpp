#include "common/watch/bus_watch.hpp"

#include <gtest/gtest.h>

namespace markservo::watch {
namespace {

std::vector<std::string> matching(const std::string& text) {
  BusWatch watch;
  for (const char* channel : {"CAM1", "CAM2", "CAMd", "STOP", "S.OP"}) {
    watch.observe(channel, reflection::MessageNote(), nullptr, 0.0);
  }
  return watch.matching(text, ChannelPattern(text));
}

TEST(BusWatch, FindsChannelsByThePatternThatAllToolsTake) {
  EXPECT_EQ(matching("CAM\\d"), (std::vector<std::string>{"CAM1", "CAM2"}));
  EXPECT_EQ(matching("CAM"), std::vector<std::string>{});
  EXPECT_EQ(matching("STO."), std::vector<std::string>{"STOP"});
}

TEST(BusWatch, TakesANameForThatChannelAlone) {
  EXPECT_EQ(matching("S.OP"), std::vector<std::string>{"S.OP"});
}

}  // namespace
}  // namespace markservo::watch
