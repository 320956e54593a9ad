// The detector looks where marks were, and now and then everywhere.

#include <gtest/gtest.h>

#include "tests/unit/mark-detector/mark_pair.hpp"

namespace markservo::mark_detector {
namespace {

using namespace test;

// Where the detector that follows marks finds them, frame by frame, beside one that searches everything.
TEST(Following, FindsMarksAsIfItLookedEverywhere) {
  Parameters thorough;
  thorough.search.full_scan_every = 1;
  State following;
  State searching;
  for (int frame = 0; frame < 12; ++frame) {
    Pair pair;
    const double moved = 7.0 * frame;  // px
    pair.draw({420.3 - moved, 250.7 + moved, kHandEdge, 0.1, kGreen, 0.1}, kDisparity + 2.0 * frame);
    pair.draw({320.1 + 0.2 * moved, 150.2, kEdge, 0.0, kRed, 0.1}, kDisparity);
    pair.left.fill(40, 400, 30, 30, kRed);
    const Input input = pair.expose(1.0, 3.0, static_cast<unsigned>(frame));
    const Output& followed = MarkDetector(four_marks(), {}).step(input, following);
    const Output& searched = MarkDetector(four_marks(), thorough).step(input, searching);
    for (std::size_t i = 0; i < 4; ++i) {
      EXPECT_EQ(followed.marks[i].reason, searched.marks[i].reason) << frame;
      EXPECT_EQ(followed.marks[i].left.shape.u, searched.marks[i].left.shape.u) << frame;
      EXPECT_EQ(followed.marks[i].right.shape.area, searched.marks[i].right.shape.area) << frame;
      EXPECT_EQ(followed.marks[i].left.patch.bgr, searched.marks[i].left.patch.bgr) << frame;
      EXPECT_EQ(followed.marks[i].right.patch.mask, searched.marks[i].right.patch.mask) << frame;
    }
  }
}

TEST(Following, SeesThatAMarkReachesOutOfWhereItLooked) {
  Parameters thorough;
  thorough.search.full_scan_every = 1;
  State following;
  State searching;
  for (int frame = 0; frame < 4; ++frame) {
    Pair pair;
    pair.draw({320.1, 150.2, kEdge, 0.0, kRed, 0.1}, kDisparity);
    if (frame > 0) {  // a thin thing of its colour beside it
      pair.left.fill(355, 150, 100, 2, kRed);
      pair.right.fill(355 - static_cast<int>(kDisparity), 150, 100, 2, kRed);
    }
    const Input input = pair.expose(1.0, 0.0);
    const Output& followed = MarkDetector(four_marks(), {}).step(input, following);
    const Output& searched = MarkDetector(four_marks(), thorough).step(input, searching);
    EXPECT_EQ(followed.marks[1].left.shape.width, searched.marks[1].left.shape.width) << frame;
    EXPECT_EQ(followed.marks[1].reason, searched.marks[1].reason) << frame;
  }
}

TEST(Following, FindsAMarkThatAppearsAnywhereAtOnce) {
  const MarkDetector detector(four_marks(), {});
  for (int place = 0; place < 24; ++place) {
    State state;
    Pair without;
    without.draw({420.3, 250.7, kHandEdge, 0.1, kGreen, 0.1}, kDisparity);
    for (int frame = 0; frame <= place % 5; ++frame) detector.step(without.expose(), state);
    Pair with = without;
    const double u = 260.0 + 55.0 * (place % 6);
    const double v = 60.0 + 100.0 * (place / 6);
    with.draw({u, v, kEdge, 0.0, kYellow, 0.1}, kDisparity);
    const Finding& finding = detector.step(with.expose(), state).marks[2];
    EXPECT_EQ(finding.reason, "") << place;
    EXPECT_NEAR(finding.left.shape.u, u, 0.5) << place;
  }
}

TEST(Following, FindsAMarkAgainThatJumped) {
  const MarkDetector detector(four_marks(), {});
  State state;
  for (int frame = 0; frame < 10; ++frame) {
    Pair pair;
    const double u = frame % 2 == 0 ? 300.0 : 540.0;
    pair.draw({u, 150.2, kEdge, 0.0, kRed, 0.1}, kDisparity);
    EXPECT_NEAR(detector.step(pair.expose(), state).marks[1].left.shape.u, u, 0.5) << frame;
  }
}

}  // namespace
}  // namespace markservo::mark_detector
