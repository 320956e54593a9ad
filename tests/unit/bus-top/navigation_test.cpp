#include "services/bus-top/navigation.hpp"

#include <gtest/gtest.h>

namespace markservo::bus_top {
namespace {

const std::vector<std::string> kChannels{"A", "B", "C", "D", "E"};
constexpr int kLines = 5;
constexpr int kRows = 2;

TEST(Navigation, MovesTheSelectionWithinTheTable) {
  Navigation view;
  EXPECT_EQ(view.selected(kChannels), 0);
  view.press(Key::kUp, kChannels, kLines, kRows);
  EXPECT_EQ(view.selected(kChannels), 0);
  view.press(Key::kDown, kChannels, kLines, kRows);
  EXPECT_EQ(view.selected(kChannels), 1);
  view.press(Key::kPageDown, kChannels, kLines, kRows);
  EXPECT_EQ(view.selected(kChannels), 3);
  view.press(Key::kEnd, kChannels, kLines, kRows);
  view.press(Key::kDown, kChannels, kLines, kRows);
  EXPECT_EQ(view.selected(kChannels), 4);
  view.press(Key::kHome, kChannels, kLines, kRows);
  EXPECT_EQ(view.selected(kChannels), 0);
}

TEST(Navigation, KeepsTheSelectedChannelInSight) {
  Navigation view;
  for (int i = 0; i < 3; ++i) view.press(Key::kDown, kChannels, kLines, kRows);
  const int first = view.first_line(kChannels, kLines, kRows);
  EXPECT_LE(first, 3);
  EXPECT_GT(first + kRows, 3);
}

TEST(Navigation, StaysWithItsChannelWhenOthersAppear) {
  Navigation view;
  view.press(Key::kDown, kChannels, kLines, kRows);
  EXPECT_EQ(view.selected({"A", "AA", "AB", "B"}), 3);
}

TEST(Navigation, OpensAndLeavesAChannel) {
  Navigation view;
  view.press(Key::kDown, kChannels, kLines, kRows);
  view.press(Key::kOpen, kChannels, kLines, kRows);
  EXPECT_EQ(view.opened(), "B");
  view.press(Key::kBack, kChannels, 30, kRows);
  EXPECT_FALSE(view.in_fields());
  EXPECT_EQ(view.selected(kChannels), 1);
}

TEST(Navigation, ScrollsTheFieldsFromEndToEnd) {
  Navigation view("B");
  EXPECT_EQ(view.first_line(kChannels, 10, 4), 0);
  view.press(Key::kEnd, kChannels, 10, 4);
  EXPECT_EQ(view.first_line(kChannels, 10, 4), 6);
  view.press(Key::kUp, kChannels, 10, 4);
  EXPECT_EQ(view.first_line(kChannels, 10, 4), 5);
  EXPECT_EQ(view.first_line(kChannels, 3, 4), 0) << "a shorter message has come";
}

TEST(Navigation, OpensNothingWhereThereIsNothing) {
  Navigation view;
  view.press(Key::kOpen, {}, 1, kRows);
  EXPECT_FALSE(view.in_fields());
  EXPECT_EQ(view.selected({}), -1);
}

TEST(Navigation, QuitsFromEverywhere) {
  Navigation table;
  Navigation fields("B");
  EXPECT_FALSE(table.quit());
  table.press(Key::kQuit, kChannels, kLines, kRows);
  fields.press(Key::kQuit, kChannels, kLines, kRows);
  EXPECT_TRUE(table.quit());
  EXPECT_TRUE(fields.quit());
}

}  // namespace
}  // namespace markservo::bus_top
