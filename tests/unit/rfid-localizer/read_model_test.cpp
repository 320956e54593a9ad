#include "services/rfid-localizer/read_model.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

namespace markservo::rfid_localizer {
namespace {

double logistic(double distance, double radius, double softness) {
  return 1.0 / (1.0 + std::exp((distance - radius) / softness));
}

TEST(ReadModel, ATagAtTheRadiusAnswersEveryOtherTime) {
  for (const double radius : {0.05, 0.1, 0.2}) EXPECT_NEAR(ReadModel(radius, 0.01).inside(radius * radius), 0.5, 0.001);
}

TEST(ReadModel, IsTheLogisticWithinAThousandthWhereTheEdgeIsNotSofterThanAFifthOfTheRadius) {
  for (const double radius : {0.05, 0.1, 0.2, 0.4}) {
    for (const double softness : {0.2 * radius, 0.1 * radius, 0.02 * radius}) {
      const ReadModel model(radius, softness);
      for (double d = 0.0; d < 3.0 * radius; d += 0.0007) {
        ASSERT_NEAR(model.inside(d * d), logistic(d, radius, softness), 0.001) << d << " of " << radius;
      }
    }
  }
}

TEST(ReadModel, NothingAnswersBeyondItsReach) {
  const ReadModel model(0.1, 0.01);
  EXPECT_GT(model.inside(std::pow(0.999 * model.reach(), 2)), 0.0);
  EXPECT_EQ(model.inside(std::pow(1.001 * model.reach(), 2)), 0.0);
  EXPECT_EQ(model.inside(1e300), 0.0);
  EXPECT_EQ(model.inside(std::numeric_limits<double>::infinity()), 0.0);
}

TEST(ReadModel, RefusesWhatIsNoLengthAndSaysWhich) {
  const double nan = std::nan("");
  for (const auto& [radius, softness] : {std::pair(0.0, 0.01), std::pair(0.1, 0.0), std::pair(-0.1, 0.01),
                                         std::pair(0.1, -0.01), std::pair(nan, 0.01), std::pair(0.1, nan)}) {
    EXPECT_THROW(ReadModel(radius, softness), std::invalid_argument) << radius << ", " << softness;
  }
  try {
    ReadModel(0.1, -0.25);
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_NE(std::string(error.what()).find("-0.25"), std::string::npos) << error.what();
    EXPECT_NE(std::string(error.what()).find("allowed"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace markservo::rfid_localizer
