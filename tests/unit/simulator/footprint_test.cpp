#include "services/simulator/contacts/footprint.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace markservo::simulator {
namespace {

const Footprint kSquare{{0.0, 0.0}, {0.5, 0.5}, 0.0};

TEST(Footprint, SidesThatFaceEachOtherAreTheirGapApart) {
  EXPECT_NEAR(distance(kSquare, {{2.0, 0.2}, {0.5, 3.0}, 0.0}), 1.0, 1e-12);
}

TEST(Footprint, CornersCountWhereTheyAreNearest) {
  EXPECT_NEAR(distance(kSquare, {{2.0, 2.0}, {0.5, 0.5}, 0.0}), std::sqrt(2.0), 1e-12);
  EXPECT_NEAR(distance(kSquare, {{2.0, 0.0}, {0.5, 0.5}, 0.25 * M_PI}), 1.5 - std::sqrt(0.5), 1e-12);
}

TEST(Footprint, OverlappingRectanglesTouchEvenIfNoCornerIsInside) {
  EXPECT_EQ(distance(kSquare, {{0.0, 0.0}, {3.0, 0.1}, 0.0}), 0.0) << "a cross";
  EXPECT_EQ(distance(kSquare, {{0.1, 0.0}, {0.1, 0.1}, 1.0}), 0.0) << "one within the other";
}

TEST(Footprint, DistanceDoesNotDependOnTheOrder) {
  const Footprint turned{{1.3, 0.9}, {0.4, 0.1}, 0.7};
  EXPECT_GT(distance(kSquare, turned), 0.0);
  EXPECT_EQ(distance(kSquare, turned), distance(turned, kSquare));
}

}  // namespace
}  // namespace markservo::simulator
