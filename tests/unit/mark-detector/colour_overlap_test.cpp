#include "services/mark-detector/colour/colour_overlap.hpp"

#include <gtest/gtest.h>

namespace markservo::mark_detector {
namespace {

const robot::ColourInterval kRed{345.0, 15.0, 0.5, 1.0, 0.2, 1.0};

robot::MarkDescription mark(const std::string& name, double hue_min_deg, double hue_max_deg) {
  robot::MarkDescription mark;
  mark.name = name;
  mark.colour = {hue_min_deg, hue_max_deg, 0.5, 1.0, 0.2, 1.0};
  return mark;
}

TEST(ColourOverlap, IsWhereSomeColourIsInBothIntervals) {
  EXPECT_TRUE(overlap(kRed, {10.0, 30.0, 0.5, 1.0, 0.2, 1.0}));
  EXPECT_TRUE(overlap({10.0, 30.0, 0.5, 1.0, 0.2, 1.0}, kRed));
  EXPECT_TRUE(overlap(kRed, {350.0, 355.0, 0.5, 1.0, 0.2, 1.0}));
  EXPECT_FALSE(overlap(kRed, {16.0, 30.0, 0.5, 1.0, 0.2, 1.0}));
  EXPECT_FALSE(overlap(kRed, {350.0, 355.0, 0.1, 0.4, 0.2, 1.0}));
  EXPECT_TRUE(overlap(kRed, {0.0, 360.0, 0.0, 1.0, 0.0, 1.0}));
}

TEST(ColourOverlap, IsToldOfEachTwoMarks) {
  EXPECT_EQ(
      told_of_overlaps({mark("red", 345.0, 15.0), mark("orange", 10.0, 30.0), mark("green", 100.0, 140.0)}),
      std::vector<std::string>{"red (hue 345 to 15 degrees) overlaps orange (hue 10 to 30 degrees): what has both "
                               "colours is taken for both"});
  EXPECT_TRUE(told_of_overlaps({mark("red", 345.0, 15.0), mark("green", 100.0, 140.0)}).empty());
}

}  // namespace
}  // namespace markservo::mark_detector
