#include "tests/experiments/localisation/paper_score.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/experiments/localisation/case_result.hpp"
#include "tests/unit/experiments/localisation_paths.hpp"

namespace markservo::experiments {
namespace {

const Eigen::Vector2d kNoLever = Eigen::Vector2d::Zero();

// A robot along +y at 0.4 m/s; the average is 0.19 s late, the compensation half a centimetre short.
std::vector<PaperRead> late_reads() {
  std::vector<PaperRead> reads;
  for (int i = 0; i < 6; ++i) {
    const double time = 0.1 * i;
    const double y = 0.4 * time;
    reads.push_back({time, {0.01, y - 0.076}, {0.0, y - 0.005}, {0.0, y + 0.001}});
  }
  return reads;
}

TruePath along_y() {
  return straight({0.0, 0.0}, M_PI / 2.0, 0.4, 10.0);
}

TEST(PaperScore, IsTheDifferenceToTheTruthAtTheReadPerAxis) {
  const auto errors = score_paper(late_reads(), along_y(), kNoLever, 0.0, 1.0);
  ASSERT_EQ(errors.size(), 6U);
  EXPECT_NEAR(errors[2].measured.x(), 0.01, 1e-12);
  EXPECT_NEAR(errors[2].measured.y(), -0.076, 1e-12);
  EXPECT_NEAR(errors[2].compensated.y(), -0.005, 1e-12);
  EXPECT_NEAR(errors[2].fused.y(), 0.001, 1e-12);
}

TEST(PaperScore, IsTakenAtTheAntenna) {
  const auto errors = score_paper(late_reads(), along_y(), {0.1, 0.0}, 0.0, 1.0);
  EXPECT_NEAR(errors[0].measured.y(), -0.176, 1e-12);
}

TEST(PaperScore, NumbersReadsThatItDoesNotScore) {
  const auto errors = score_paper(late_reads(), along_y(), kNoLever, 0.15, 0.45);
  ASSERT_EQ(errors.size(), 3U);
  EXPECT_EQ(errors[0].read, 3);
}

TEST(PaperScore, CountsComponentsFromTheGivenReadOn) {
  const auto errors = score_paper(late_reads(), along_y(), kNoLever, 0.0, 1.0);
  EXPECT_EQ(components(errors, PaperValue::kMeasured, Axis::kY, 4).size(), 3U);
  EXPECT_NEAR(components(errors, PaperValue::kMeasured, Axis::kX, 1)[0], 0.01, 1e-12);
  EXPECT_NEAR(components(errors, PaperValue::kMeasured, Axis::kAlong, 1)[0], -0.076, 1e-12);
  EXPECT_NEAR(components(errors, PaperValue::kFused, Axis::kY, 1)[0], 0.001, 1e-12);
}

TEST(PaperScore, SaysWhatCompensationTakesAway) {
  const auto errors = score_paper(late_reads(), along_y(), kNoLever, 0.0, 1.0);
  EXPECT_NEAR(compensation_gain(errors, Axis::kY, 1), 1.0 - 0.005 / 0.076, 1e-9);
}

TEST(AbsoluteSpread, IsMeanGreatestAndLeastOfTheSizes) {
  const Spread spread = absolute_spread({-0.04, 0.01, 0.01});
  EXPECT_NEAR(spread.mean, 0.02, 1e-12);
  EXPECT_NEAR(spread.max, 0.04, 1e-12);
  EXPECT_NEAR(spread.min, 0.01, 1e-12);
  EXPECT_EQ(spread.n, 3);
  EXPECT_TRUE(std::isnan(absolute_spread({}).mean));
}

}  // namespace
}  // namespace markservo::experiments
