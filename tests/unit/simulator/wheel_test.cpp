#include <gtest/gtest.h>

#include <cmath>

#include "services/simulator/base/wheel_encoder.hpp"
#include "services/simulator/base/wheel_grip.hpp"

namespace markservo::simulator {
namespace {

TEST(WheelEncoder, CountsWholeTicksAndWrapsAroundBothWays) {
  WheelEncoder encoder(0.001, 8, 254);
  EXPECT_EQ(encoder.counter(), 254);
  encoder.turn(0.0035);
  EXPECT_EQ(encoder.counter(), 1);
  EXPECT_DOUBLE_EQ(encoder.distance(), 0.003);
  encoder.turn(-0.004);
  EXPECT_EQ(encoder.counter(), 253);
  EXPECT_DOUBLE_EQ(encoder.distance(), -0.001);
}

TEST(WheelGrip, WithoutSlipAndNoiseGoesAsItTurns) {
  WheelGrip grip({}, 1);
  for (const double turned : {0.01, -0.3, 0.0, 0.2}) EXPECT_EQ(grip.roll(turned), turned);
}

TEST(WheelGrip, SlipsByItsShareOnAverage) {
  WheelGrip grip({0.2, 0.0}, 1);
  double way = 0.0;
  for (int i = 0; i < 100'000; ++i) way += grip.roll(0.01);
  EXPECT_NEAR(way, 0.8 * 1000.0, 10.0);
}

TEST(WheelGrip, WalksAtRandomByTheRootOfTheWay) {
  constexpr double kNoise = 0.01;  // m per sqrt(m)
  double squares = 0.0;
  for (std::uint64_t seed = 0; seed < 400; ++seed) {
    WheelGrip grip({0.0, kNoise}, seed);
    double way = 0.0;
    for (int i = 0; i < 400; ++i) way += grip.roll(0.01);
    squares += (way - 4.0) * (way - 4.0);
  }
  EXPECT_NEAR(std::sqrt(squares / 400.0), kNoise * std::sqrt(4.0), 0.15 * kNoise * std::sqrt(4.0));
}

}  // namespace
}  // namespace markservo::simulator
