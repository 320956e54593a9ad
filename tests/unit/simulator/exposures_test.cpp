#include "services/simulator/cameras/exposures.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace markservo::simulator {
namespace {

constexpr double kRate_hz = 10.0;
constexpr std::int64_t kPeriod = 50;  // steps

TEST(Exposures, TheFirstIsDueAtOnceAndTheNextAPeriodLater) {
  Exposures exposures(kRate_hz, 7);
  EXPECT_FALSE(exposures.due(6));
  EXPECT_TRUE(exposures.due(7));
  exposures.expose(7, 1);
  EXPECT_FALSE(exposures.due(7 + kPeriod - 1));
  EXPECT_TRUE(exposures.due(7 + kPeriod));
}

TEST(Exposures, AnAnswerToASentFrameCountsFromTheExposedOne) {
  Exposures exposures(kRate_hz, 0);
  exposures.expose(0, 1);
  exposures.expose(0, 2);  // sent again
  exposures.expose(kPeriod, 3);
  EXPECT_EQ(exposures.number(), 2);
  EXPECT_EQ(exposures.number_of(3), 2);
  EXPECT_EQ(exposures.number_of(2), 1);
  EXPECT_EQ(exposures.number_of(4), 2) << "what is not sent yet is not answered before the exposed one";
}

TEST(Exposures, ANewRateBeforeTheFirstExposureDelaysNothing) {
  Exposures exposures(kRate_hz, 0);
  exposures.change_rate(2.0 * kRate_hz, 3);
  EXPECT_TRUE(exposures.due(3));
}

TEST(Exposures, ARestartCountsFromOneAgain) {
  Exposures exposures(kRate_hz, 0);
  exposures.expose(0, 1);
  exposures.expose(kPeriod, 2);
  exposures.begin_anew(kRate_hz, 500);
  EXPECT_EQ(exposures.number(), 0);
  EXPECT_TRUE(exposures.due(500));
  exposures.expose(500, 3);
  EXPECT_EQ(exposures.number(), 1);
}

TEST(Exposures, WhichAreLostIsTheSeedsAndTheNumbersAlone) {
  const auto lost = [](std::uint64_t seed, std::int64_t first_step) {
    Exposures exposures(kRate_hz, first_step);
    std::vector<bool> all;
    for (std::int64_t i = 0; i < 50; ++i) {
      exposures.expose(first_step + i * kPeriod, i);
      all.push_back(exposures.lost(seed, 0.5));
    }
    return all;
  };
  EXPECT_EQ(lost(1, 0), lost(1, 123));
  EXPECT_NE(lost(1, 0), lost(2, 0));
}

}  // namespace
}  // namespace markservo::simulator
