#include "services/simulator/readers/sonar_model.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

namespace markservo::simulator {
namespace {

constexpr std::size_t kRays = SonarModel::kRaysPerBeam;
const SonarParameters kIdeal{0.0, 0.0};

robot::SonarRingDescription ring() {
  robot::SonarRingDescription ring;
  ring.number = 4;
  ring.ring_radius = 0.2;
  ring.height = 0.25;
  ring.beam_width = 0.5;
  ring.min_range = 0.1;
  ring.max_range = 5.0;
  return ring;
}

std::vector<std::optional<double>> nothing() {
  return std::vector<std::optional<double>>(4 * kRays);
}

TEST(SonarModel, ItsRaysFillTheBeamsFromTheRingOutward) {
  const auto rays = SonarModel(ring(), 1).rays();
  ASSERT_EQ(rays.size(), 4 * kRays);
  for (std::size_t i = kRays; i < 2 * kRays; ++i) {
    EXPECT_LT((rays[i].origin - Eigen::Vector3d(0.0, 0.2, 0.25)).norm(), 1e-12) << "sonar 1 looks to the left";
    EXPECT_NEAR(rays[i].direction.norm(), 1.0, 1e-12);
  }
  EXPECT_NEAR(std::atan2(rays[kRays].direction.y(), rays[kRays].direction.x()), 0.5 * M_PI - 0.25, 1e-12);
  EXPECT_NEAR(std::atan2(rays[2 * kRays - 1].direction.y(), rays[2 * kRays - 1].direction.x()), 0.5 * M_PI + 0.25,
              1e-12);
}

TEST(SonarModel, HearsTheNearestThingInTheBeam) {
  auto distances = nothing();
  distances[kRays + 2] = 1.5;
  distances[kRays + 4] = 0.8;
  SonarModel sonars(ring(), 1);
  const SonarReading reading = sonars.listen(distances, kIdeal, 77);
  ASSERT_EQ(reading.echoes.size(), 4U);
  EXPECT_EQ(reading.utime, 77);
  EXPECT_TRUE(reading.echoes[1].heard);
  EXPECT_EQ(reading.echoes[1].range, 0.8);
  EXPECT_NEAR(reading.echoes[1].X_RS.y, 0.2, 1e-12);
  EXPECT_NEAR(reading.echoes[1].X_RS.heading, 0.5 * M_PI, 1e-12);
}

TEST(SonarModel, BeyondItsRangesItHearsNothingOrTheLeast) {
  auto distances = nothing();
  distances[0] = 6.0;
  distances[kRays] = 0.02;
  SonarModel sonars(ring(), 1);
  const SonarReading reading = sonars.listen(distances, kIdeal, 0);
  EXPECT_FALSE(reading.echoes[0].heard);
  EXPECT_EQ(reading.echoes[0].range, 5.0);
  EXPECT_TRUE(reading.echoes[1].heard);
  EXPECT_EQ(reading.echoes[1].range, 0.1);
  EXPECT_FALSE(reading.echoes[2].heard);
}

TEST(SonarModel, NoiseAndLossesAreAsLargeAsTold) {
  std::vector<std::optional<double>> distances(4 * kRays, 1.0);
  SonarModel sonars(ring(), 1);
  double squares = 0.0;
  int heard = 0;
  constexpr int kScans = 1000;
  for (int i = 0; i < kScans; ++i) {
    for (const auto& echo : sonars.listen(distances, {0.01, 0.1}, i).echoes) {
      if (!echo.heard) continue;
      ++heard;
      squares += std::pow(echo.range - 1.0, 2);
    }
  }
  EXPECT_NEAR(heard, 3600, 4.0 * std::sqrt(4000 * 0.09));
  EXPECT_NEAR(std::sqrt(squares / heard), 0.01, 4.0 * 0.01 / std::sqrt(2.0 * heard));
}

TEST(SonarModel, RefusesAnotherNumberOfDistances) {
  SonarModel sonars(ring(), 1);
  EXPECT_THROW(sonars.listen({1.0}, kIdeal, 0), std::invalid_argument);
}

}  // namespace
}  // namespace markservo::simulator
