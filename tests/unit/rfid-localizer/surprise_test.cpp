#include "services/rfid-localizer/surprise.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace markservo::rfid_localizer {
namespace {

constexpr double kLeast = 1e-4;

double log_probability(const std::vector<double>& chances, const std::vector<bool>& reads) {
  double sum = 0.0;
  for (std::size_t i = 0; i < chances.size(); ++i) sum += std::log(reads[i] ? chances[i] : 1.0 - chances[i]);
  return sum;
}

// The average of what tags with these chances do is no surprise, be they many or few.
TEST(Surprise, OfOutcomesThatFollowTheChancesIsAroundNothing) {
  std::mt19937_64 bits(4);
  for (const std::size_t tags : {3U, 12U, 60U}) {
    std::vector<double> chances;
    for (std::size_t i = 0; i < tags; ++i)
      chances.push_back(0.05 + 0.9 * static_cast<double>(i) / static_cast<double>(tags));
    double sum = 0.0;
    double squares = 0.0;
    constexpr int kRounds = 4000;
    for (int round = 0; round < kRounds; ++round) {
      std::vector<bool> reads;
      for (const double chance : chances) reads.push_back(std::bernoulli_distribution(chance)(bits));
      const double value = surprise(chances, log_probability(chances, reads), kLeast);
      sum += value / kRounds;
      squares += value * value / kRounds;
    }
    EXPECT_NEAR(sum, 0.0, 0.06) << tags << " tags";
    EXPECT_LT(squares, 1.1) << tags << " tags";
  }
}

TEST(Surprise, OfTheLikeliestOutcomeIsBelowNothing) {
  EXPECT_LT(surprise({0.95, 0.95, 0.05}, log_probability({0.95, 0.95, 0.05}, {true, true, false}), kLeast), 0.0);
}

TEST(Surprise, OfSilencesAndReadsTheWrongWayAroundIsLarge) {
  EXPECT_GT(surprise({0.95, 0.95, 0.05}, log_probability({0.95, 0.95, 0.05}, {false, false, true}), kLeast), 4.0);
}

TEST(Surprise, WithoutTagsIsNone) {
  EXPECT_EQ(surprise({}, 0.0, kLeast), 0.0);
}

TEST(Surprise, IsFiniteForCertainties) {
  EXPECT_TRUE(std::isfinite(surprise({0.0, 1.0, 1.0 + 1e-12}, std::log(1e-300), kLeast)));
}

}  // namespace
}  // namespace markservo::rfid_localizer
