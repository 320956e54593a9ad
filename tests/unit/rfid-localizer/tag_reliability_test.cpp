#include "services/rfid-localizer/tag_reliability.hpp"

#include <gtest/gtest.h>

#include <random>

namespace markservo::rfid_localizer {
namespace {

TEST(TagReliability, BeginsWithWhatTheReaderIsKnownFor) {
  const TagReliability reliability(3, {});
  EXPECT_NEAR(reliability.read_probability(), 0.95, 1e-12);
  EXPECT_NEAR(reliability.of(1), 0.99 * 0.95, 1e-12);
}

TEST(TagReliability, SuspectsADeadTagAfterAFewSilencesAndNoOther) {
  TagReliability reliability(3, {});
  reliability.learn(1, false, 1.0);
  EXPECT_LT(reliability.gone(1), 0.5) << "one silence is nothing";
  for (int i = 0; i < 3; ++i) reliability.learn(1, false, 1.0);
  EXPECT_GT(reliability.gone(1), 0.95);
  EXPECT_LT(reliability.of(1), 0.05);
  EXPECT_EQ(reliability.gone(0), 0.01);
}

TEST(TagReliability, ForgivesATagAtItsFirstRead) {
  TagReliability reliability(3, {});
  for (int i = 0; i < 1000; ++i) reliability.learn(1, false, 1.0);
  reliability.learn(1, true, 1.0);
  EXPECT_LT(reliability.gone(1), 0.01);
  EXPECT_GT(reliability.of(1), 0.8);
}

TEST(TagReliability, ASilenceOutsideTheFootprintSaysNothing) {
  TagReliability reliability(3, {});
  for (int i = 0; i < 1000; ++i) reliability.learn(1, false, 0.0);
  EXPECT_NEAR(reliability.gone(1), 0.01, 1e-9);
  EXPECT_NEAR(reliability.read_probability(), 0.95, 1e-12);
}

TEST(TagReliability, LearnsThatAFifthOfTheReadsIsMissedBesides) {
  TagReliability reliability(50, {});
  std::mt19937_64 bits(3);
  std::bernoulli_distribution read(0.8 * 0.95);
  double sum = 0.0;
  constexpr int kTrials = 20'000;
  for (int i = 0; i < kTrials; ++i) {
    reliability.learn(i % 50, read(bits), 1.0);
    if (i >= kTrials / 2) sum += reliability.read_probability() / (kTrials / 2);
  }
  EXPECT_NEAR(sum, 0.76, 0.015);
}

TEST(TagReliability, DeadTagsDoNotSpoilTheReadersName) {
  TagReliability reliability(50, {});
  std::mt19937_64 bits(4);
  std::bernoulli_distribution read(0.95);
  for (int i = 0; i < 20'000; ++i) {
    const int tag = i % 50;
    reliability.learn(tag, tag >= 5 && read(bits), 1.0);
  }
  EXPECT_NEAR(reliability.read_probability(), 0.95, 0.04);
}

TEST(TagReliability, StaysAProbabilityWhateverItHears) {
  TagReliability deaf(1, {});
  for (int i = 0; i < 5000; ++i) {
    deaf.learn(0, i % 50 == 0, 1.0);
    ASSERT_GT(deaf.of(0), -1e-12);
    ASSERT_GE(deaf.read_probability(), 0.29);
  }
  TagReliability keen(1, {});
  for (int i = 0; i < 5000; ++i) keen.learn(0, true, 1.0);
  EXPECT_LE(keen.read_probability(), 0.9951);
}

}  // namespace
}  // namespace markservo::rfid_localizer
