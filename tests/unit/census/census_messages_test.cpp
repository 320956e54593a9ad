#include "common/census/census_messages.hpp"

#include <gtest/gtest.h>

#include "tests/unit/encoded.hpp"

namespace markservo::census {
namespace {

ServiceStatus status() {
  ServiceStatus status{};
  status.utime = 1'700'000'000'000'000;
  status.session = 5;
  status.seq = 1;
  status.name = "visual-servo";
  status.host = "here";
  status.state = "ready";
  return status;
}

std::optional<ServiceWord> heard(const ServiceStatus& message, const std::string& channel = "SERVICE_STATUS") {
  const auto bytes = test::encoded(message);
  return word_in(channel, bytes.data(), bytes.size());
}

TEST(ServiceWord, IsHeardOnItsChannelOfAnyRobot) {
  ASSERT_TRUE(heard(status()));
  EXPECT_EQ(heard(status())->name, "visual-servo");
  ASSERT_TRUE(heard(status(), "r1/SERVICE_STATUS"));
  EXPECT_EQ(heard(status(), "r1/SERVICE_STATUS")->robot, "r1");
}

TEST(ServiceWord, IsNoneOnAnotherChannel) {
  for (const char* channel : {"POSE", "", "MY_SERVICE_STATUS", "SERVICE_STATUS/x"}) {
    EXPECT_FALSE(heard(status(), channel)) << channel;
  }
}

TEST(ServiceWord, IsNoneThatBreaksARuleOfItsType) {
  ServiceStatus broken = status();
  broken.name = "evil\x1b[2J";
  EXPECT_FALSE(heard(broken));
  broken = status();
  broken.reason = std::string(201, 'x');
  EXPECT_FALSE(heard(broken));
  broken = status();
  broken.session = 0;
  EXPECT_FALSE(heard(broken));
  broken = status();
  broken.utime = -1;
  EXPECT_FALSE(heard(broken));
  broken = status();
  broken.num_channels = 1;
  broken.channels.resize(1);
  broken.channels[0].lost = -1;
  EXPECT_FALSE(heard(broken));
}

}  // namespace
}  // namespace markservo::census
