#include "common/bus/health.hpp"

#include <gtest/gtest.h>

namespace markservo::bus {
namespace {

NeededInput input(const std::string& channel) {
  NeededInput input;
  input.channel = channel;
  input.max_age = 3.0;
  return input;
}

TEST(Health, AllThatIsNeededIsThere) {
  NeededInput frames = input("STEREO_FRAME");
  frames.accepted_age = 2.9;
  EXPECT_FALSE(health_of({frames}));
  EXPECT_FALSE(health_of({})) << "nothing is needed";
}

TEST(Health, NeverHeardIsWaiting) {
  const auto health = health_of({input("STEREO_FRAME")});
  ASSERT_TRUE(health);
  EXPECT_EQ(*health, (Health{"waiting", "STEREO_FRAME: not heard yet"}));
}

TEST(Health, HeardOnceIsStale) {
  NeededInput frames = input("STEREO_FRAME");
  frames.accepted_age = 3.1;
  EXPECT_EQ(health_of({frames}).value(), (Health{"stale", "STEREO_FRAME: not heard for more than 3 s"}));
}

TEST(Health, AllRefusedIsNotHavingItAndSaysWhy) {
  NeededInput frames = input("STEREO_FRAME");
  frames.refused_age = 0.1;
  frames.refusal = "utime is 3600 s ahead of this host's clock";
  EXPECT_EQ(health_of({frames}).value(),
            (Health{"waiting", "STEREO_FRAME: all refused: utime is 3600 s ahead of this host's clock"}));
  frames.accepted_age = 60.0;
  EXPECT_EQ(health_of({frames})->state, "stale");
  frames.accepted_age = 1.0;
  EXPECT_FALSE(health_of({frames})) << "one refused among others";
  frames.accepted_age = 60.0;
  frames.refused_age = 60.0;
  EXPECT_EQ(health_of({frames})->reason, "STEREO_FRAME: not heard for more than 3 s") << "refused long ago";
}

TEST(Health, FirstThatIsMissingIsNamed) {
  NeededInput joints = input("JOINT_STATE");
  joints.accepted_age = 0.0;
  EXPECT_EQ(health_of({joints, input("TARGET_POSE"), input("STOP_STATE")})->reason, "TARGET_POSE: not heard yet");
}

TEST(Health, BusSpeaksBeforeTheServiceAndTheServiceAgainAfterwards) {
  const Health own{"servo", "2 mm to go"};
  const Health deaf{"stale", "TARGET_POSE: not heard for more than 3 s"};
  const Health network{"waiting", "no network"};
  EXPECT_EQ(told_health(own, std::nullopt, std::nullopt), own);
  EXPECT_EQ(told_health(own, std::nullopt, deaf), deaf);
  EXPECT_EQ(told_health(own, network, deaf), network);
}

TEST(Health, ServiceThatSaysWhyItCannotWorkKnowsBest) {
  const Health own{"waiting", "for the camera /dev/video0"};
  const Health deaf{"waiting", "TARGET_POSE: not heard yet"};
  EXPECT_EQ(told_health(own, std::nullopt, deaf), own);
  EXPECT_EQ(told_health(Health{"waiting", ""}, std::nullopt, deaf), deaf);
  EXPECT_EQ(told_health(Health{"starting", ""}, std::nullopt, deaf), deaf);
}

}  // namespace
}  // namespace markservo::bus
