#include "services/mark-detector/search/track.hpp"

#include <gtest/gtest.h>

#include <set>
#include <utility>

#include "services/mark-detector/search/search_schedule.hpp"

namespace markservo::mark_detector {
namespace {

constexpr int kWidth = 640;
constexpr int kHeight = 480;
constexpr int kMemory = 3;

Track seen() {
  Shape left;
  left.u = 300.0;
  left.v = 200.0;
  Shape right = left;
  right.u = 100.0;
  return track_of(left, right, kWidth, kHeight);
}

TEST(Track, KnowsWhereTheMarkWasInBothImages) {
  const Track track = seen();
  EXPECT_TRUE(track.known);
  EXPECT_EQ(track.place.u_left, 300.0);
  EXPECT_EQ(track.place.v_left, 200.0);
  EXPECT_EQ(track.place.u_right, 100.0);
}

TEST(Track, IsFreshInTheNextFrameOnly) {
  Track track = seen();
  EXPECT_FALSE(track.is_fresh());
  track.begin_frame(kWidth, kHeight, kMemory);
  EXPECT_TRUE(track.is_fresh());
  track.begin_frame(kWidth, kHeight, kMemory);
  EXPECT_FALSE(track.is_fresh());
  EXPECT_TRUE(track.known);
}

TEST(Track, IsForgottenAfterItsMemory) {
  Track track = seen();
  for (int frame = 0; frame < kMemory; ++frame) track.begin_frame(kWidth, kHeight, kMemory);
  EXPECT_TRUE(track.known);
  track.begin_frame(kWidth, kHeight, kMemory);
  EXPECT_FALSE(track.known);
}

TEST(Track, IsForgottenWhenImagesChangeTheirSize) {
  for (const auto& [width, height] : {std::pair{kWidth / 2, kHeight}, std::pair{kWidth, kHeight / 2}}) {
    Track track = seen();
    track.begin_frame(width, height, kMemory);
    EXPECT_FALSE(track.known);
    EXPECT_FALSE(track.is_fresh());
  }
}

TEST(SearchSchedule, SearchesEverythingFirstAndEveryFewFrames) {
  SearchSchedule schedule;
  for (int frame = 0; frame < 12; ++frame) EXPECT_EQ(schedule.full_scan_due(4, false), frame % 4 == 0) << frame;
}

TEST(SearchSchedule, CountsFromAFrameThatWasSearchedOutOfTurn) {
  SearchSchedule schedule;
  EXPECT_TRUE(schedule.full_scan_due(3, false));
  EXPECT_FALSE(schedule.full_scan_due(3, false));
  EXPECT_TRUE(schedule.full_scan_due(3, true));
  EXPECT_FALSE(schedule.full_scan_due(3, false));
  EXPECT_FALSE(schedule.full_scan_due(3, false));
  EXPECT_TRUE(schedule.full_scan_due(3, false));
}

TEST(SearchSchedule, LooksAtEveryRowInTurn) {
  SearchSchedule schedule;
  std::set<int> rows;
  for (int frame = 0; frame < 8; ++frame) rows.insert(schedule.next_coarse_row(8));
  EXPECT_EQ(rows, (std::set<int>{0, 1, 2, 3, 4, 5, 6, 7}));
}

}  // namespace
}  // namespace markservo::mark_detector
