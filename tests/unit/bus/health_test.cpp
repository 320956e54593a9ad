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
  EXPECT_FALSE(word_about({frames}));
  EXPECT_FALSE(word_about({})) << "nothing is needed";
}

TEST(Health, NeverHeardIsWaiting) {
  const auto word = word_about({input("STEREO_FRAME")});
  ASSERT_TRUE(word);
  EXPECT_EQ(*word, (Word{"waiting", "STEREO_FRAME: not heard yet"}));
}

TEST(Health, HeardOnceIsStale) {
  NeededInput frames = input("STEREO_FRAME");
  frames.accepted_age = 3.1;
  EXPECT_EQ(word_about({frames}).value(), (Word{"stale", "STEREO_FRAME: not heard for more than 3 s"}));
}

TEST(Health, AllRefusedIsNotHavingItAndSaysWhy) {
  NeededInput frames = input("STEREO_FRAME");
  frames.refused_age = 0.1;
  frames.refusal = "utime is 3600 s ahead of this host's clock";
  EXPECT_EQ(word_about({frames}).value(),
            (Word{"waiting", "STEREO_FRAME: all refused: utime is 3600 s ahead of this host's clock"}));
  frames.accepted_age = 60.0;
  EXPECT_EQ(word_about({frames})->state, "stale");
  frames.accepted_age = 1.0;
  EXPECT_FALSE(word_about({frames})) << "one refused among others";
  frames.accepted_age = 60.0;
  frames.refused_age = 60.0;
  EXPECT_EQ(word_about({frames})->reason, "STEREO_FRAME: not heard for more than 3 s") << "refused long ago";
}

TEST(Health, FirstThatIsMissingIsNamed) {
  NeededInput joints = input("JOINT_STATE");
  joints.accepted_age = 0.0;
  EXPECT_EQ(word_about({joints, input("TARGET_POSE"), input("STOP_STATE")})->reason, "TARGET_POSE: not heard yet");
}

TEST(Health, BusSpeaksBeforeTheServiceAndTheServiceAgainAfterwards) {
  const Word own{"servo", "2 mm to go"};
  const Word deaf{"stale", "TARGET_POSE: not heard for more than 3 s"};
  const Word network{"waiting", "no network"};
  EXPECT_EQ(told_word(own, std::nullopt, std::nullopt), own);
  EXPECT_EQ(told_word(own, std::nullopt, deaf), deaf);
  EXPECT_EQ(told_word(own, network, deaf), network);
}

TEST(Health, ServiceThatSaysWhyItCannotWorkKnowsBest) {
  const Word own{"waiting", "for the camera /dev/video0"};
  const Word deaf{"waiting", "TARGET_POSE: not heard yet"};
  EXPECT_EQ(told_word(own, std::nullopt, deaf), own);
  EXPECT_EQ(told_word(Word{"waiting", ""}, std::nullopt, deaf), deaf);
  EXPECT_EQ(told_word(Word{"starting", ""}, std::nullopt, deaf), deaf);
}

}  // namespace
}  // namespace markservo::bus
