#include "services/mark-detector/mark_detector.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "tests/unit/mark-detector/mark_pair.hpp"

namespace markservo::mark_detector {
namespace {

using namespace test;

Pair four_mark_scene() {
  Pair pair;
  pair.draw({420.3, 250.7, kHandEdge, 0.1, kGreen, 0.1}, kDisparity);
  pair.draw({320.1, 150.2, kEdge, 0.0, kRed, 0.1}, kDisparity);
  pair.draw({450.8, 150.9, kEdge, 0.0, kYellow, 0.1}, kDisparity);
  pair.draw({570.4, 150.5, kEdge, 0.0, kBlue, 0.1}, kDisparity);
  return pair;
}

Output detect(const Input& input, const std::vector<robot::MarkDescription>& marks = four_marks()) {
  State state;
  return MarkDetector(marks, {}).step(input, state);
}

TEST(MarkDetector, FindsAllMarksInBothImages) {
  Pair pair = four_mark_scene();
  const Output output = detect(pair.expose());
  ASSERT_EQ(output.marks.size(), 4U);
  const double us[] = {420.3, 320.1, 450.8, 570.4};
  const double vs[] = {250.7, 150.2, 150.9, 150.5};
  for (std::size_t i = 0; i < 4; ++i) {
    const Finding& finding = output.marks[i];
    EXPECT_EQ(finding.reason, "") << finding.name;
    EXPECT_NEAR(finding.left.shape.u, us[i], kMaskError);
    EXPECT_NEAR(finding.left.shape.v, vs[i], kMaskError);
    EXPECT_NEAR(finding.right.shape.u, us[i] - kDisparity, kMaskError);
    EXPECT_NEAR(finding.right.shape.v, vs[i], kMaskError);
    EXPECT_GT(finding.separability, 0.9);
    EXPECT_GT(finding.left.patch.scale, 0);
    EXPECT_EQ(finding.left.patch.scale, finding.right.patch.scale);
  }
  EXPECT_EQ(output.marks[0].left.patch.scale, 1) << "the hand comes first";
  EXPECT_EQ(output.marks[2].left.patch.scale, 1) << "then the target nearest to the hand";
}

TEST(MarkDetector, FindsThemInAnyLightThatDoesNotSaturate) {
  for (const double gain : {0.4, 0.6, 1.0, 1.2}) {
    Pair pair = four_mark_scene();
    for (const Finding& finding : detect(pair.expose(gain)).marks)
      EXPECT_EQ(finding.reason, "") << finding.name << gain;
  }
  for (const double gain : {1.0, 2.5}) {
    Pair dim;
    dim.draw({320.1, 150.2, kEdge, 0.0, {16.0, 14.0, 76.0}, 0.1}, kDisparity);
    const Output output = detect(dim.expose(gain), {mark("red", 345.0, 15.0)});
    EXPECT_EQ(output.marks[0].reason, "") << gain;
    EXPECT_NEAR(output.marks[0].left.shape.u, 320.1, kMaskError);
  }
}

TEST(MarkDetector, NeedsEqualisationInTheDark) {
  Pair dark;
  dark.left.fill(0, 0, 640, 480, {6.0, 6.0, 6.0});
  dark.right.fill(0, 0, 640, 480, {6.0, 6.0, 6.0});
  dark.draw({320.0, 150.0, kEdge, 0.0, {6.0, 5.0, 40.0}, 0.0}, kDisparity);
  const Input input = dark.expose(1.0, 1.0);
  EXPECT_EQ(detect(input, {mark("red", 345.0, 15.0)}).marks[0].reason, "");
  Parameters plain;
  plain.equalise = false;
  State state;
  EXPECT_NE(MarkDetector({mark("red", 345.0, 15.0)}, plain).step(input, state).marks[0].reason, "");
}

TEST(MarkDetector, SaysWhatItCannotSeeAndWhy) {
  const std::vector<robot::MarkDescription> red = {mark("red", 345.0, 15.0)};
  Pair none;
  const Finding nothing = detect(none.expose(), red).marks[0];
  EXPECT_EQ(nothing.reason, "no pixel of its colour in either image");
  EXPECT_FALSE(nothing.left.seen);
  EXPECT_EQ(nothing.left.patch.scale, 0);

  Pair left_only;
  left_only.left.draw({300.0, 200.0, kEdge, 0.0, kRed, 0.0});
  const Finding one = detect(left_only.expose(), red).marks[0];
  EXPECT_EQ(one.reason, "seen in the left image only: no pixel of its colour in the right image");
  EXPECT_TRUE(one.left.seen);
  EXPECT_FALSE(one.right.seen);
  EXPECT_EQ(one.left.patch.scale, 0) << "nothing to match it with";

  Pair small;
  small.left.fill(100, 100, 4, 4, kRed);
  small.right.fill(50, 100, 4, 4, kRed);
  EXPECT_EQ(detect(small.expose(1.0, 0.0), red).marks[0].reason,
            "largest blob in the left image has 12 px, fewer than 60; largest blob in the right image has 12 px, fewer "
            "than 60");

  Pair rows;
  rows.left.draw({300.0, 200.0, kEdge, 0.0, kRed, 0.0});
  rows.right.draw({100.0, 240.0, kEdge, 0.0, kRed, 0.0});
  const Finding apart = detect(rows.expose(), red).marks[0];
  EXPECT_EQ(apart.reason.find("the blobs' rows differ by 40.0 px"), 0U) << apart.reason;
  EXPECT_FALSE(apart.left.seen);
  EXPECT_FALSE(apart.right.seen);
}

TEST(MarkDetector, IsNotTakenInByLargerThingsOfTheSameColour) {
  Pair pair;
  pair.draw({320.1, 150.2, kEdge, 0.0, kRed, 0.1}, kDisparity);
  pair.left.fill(500, 300, 130, 130, kRed);                // a distractor that one camera sees
  pair.draw({200.0, 380.0, 150.0, 0.0, kRed, 0.0}, 40.0);  // a large one far behind, which both see
  const Output output = detect(pair.expose(), {mark("red", 345.0, 15.0)});
  EXPECT_EQ(output.marks[0].reason, "");
  EXPECT_NEAR(output.marks[0].left.shape.u, 320.1, kMaskError);
  EXPECT_NEAR(output.marks[0].right.shape.u, 320.1 - kDisparity, kMaskError);
}

TEST(MarkDetector, StaysWithTheMarkItFollowed) {
  const std::vector<robot::MarkDescription> red = {mark("red", 345.0, 15.0)};
  const MarkDetector detector(red, {});
  State state;
  Pair first;
  first.draw({320.0, 150.0, kEdge, 0.0, kRed, 0.1}, kDisparity);
  detector.step(first.expose(), state);
  // Its twin, a little larger, comes into view.
  Pair second;
  second.draw({326.0, 152.0, kEdge, 0.0, kRed, 0.1}, kDisparity);
  second.draw({500.0, 350.0, kEdge + 6.0, 0.0, kRed, 0.1}, kDisparity);
  const Input both = second.expose();
  EXPECT_NEAR(detector.step(both, state).marks[0].left.shape.u, 326.0, 0.1);
  State fresh;
  EXPECT_NEAR(detector.step(both, fresh).marks[0].left.shape.u, 500.0, 0.1);
}

TEST(MarkDetector, ForgetsAPlaceAfterAWhile) {
  const std::vector<robot::MarkDescription> red = {mark("red", 345.0, 15.0)};
  Parameters parameters;
  parameters.search.memory_frames = 3;
  const MarkDetector detector(red, parameters);
  State state;
  Pair seen;
  seen.draw({320.0, 150.0, kEdge, 0.0, kRed, 0.1}, kDisparity);
  detector.step(seen.expose(), state);
  Pair none;
  const Input empty = none.expose();
  for (int i = 0; i < 3; ++i) detector.step(empty, state);
  EXPECT_TRUE(state.tracks[0].known);
  detector.step(empty, state);
  EXPECT_FALSE(state.tracks[0].known);
}

TEST(MarkDetector, GivesTheSameForTheSameFrames) {
  Pair pair = four_mark_scene();
  const Input input = pair.expose();
  const MarkDetector detector(four_marks(), {});
  State a;
  State b;
  for (int i = 0; i < 3; ++i) {
    const Output first = detector.step(input, a);
    const Output second = detector.step(input, b);
    for (std::size_t k = 0; k < first.marks.size(); ++k) {
      EXPECT_EQ(first.marks[k].left.shape.u, second.marks[k].left.shape.u);
      EXPECT_EQ(first.marks[k].left.patch.bgr, second.marks[k].left.patch.bgr);
      EXPECT_EQ(first.marks[k].right.patch.mask, second.marks[k].right.patch.mask);
    }
  }
}

TEST(MarkDetector, FillsWhatIsPrintedOnAMark) {
  Pair pair;
  pair.left.fill(300, 150, 78, 78, kRed);
  pair.right.fill(96, 150, 78, 78, kRed);
  pair.left.fill(330, 170, 12, 12, kWhite);
  pair.right.fill(126, 170, 12, 12, kWhite);
  const Finding finding = detect(pair.expose(1.0, 0.0), {mark("red", 345.0, 15.0)}).marks[0];
  EXPECT_NEAR(finding.left.shape.area, 78.0 * 78.0, 20.0);
  EXPECT_NEAR(finding.left.shape.u, 338.5, 0.05);
}

TEST(MarkDetector, TakesAllPiecesOfAFreeObject) {
  auto leaves = mark("leaves", 95.0, 150.0);
  leaves.surface = robot::MarkSurface::kFree;
  Pair pair;
  pair.draw({300.0, 150.0, 40.0, 0.3, kGreen, 0.0}, 100.0);
  pair.draw({400.0, 250.0, 30.0, 0.6, kGreen, 0.0}, 80.0);
  pair.draw({350.0, 330.0, 60.0, 0.0, kGreen, 0.0}, 120.0);
  pair.left.fill(10, 10, 5, 5, kGreen);  // too small to count
  const Finding finding = detect(pair.expose(), {leaves}).marks[0];
  EXPECT_EQ(finding.reason, "");
  EXPECT_NEAR(finding.left.shape.area, 1600.0 + 900.0 + 3600.0, 150.0);
  EXPECT_NEAR(finding.left.shape.x, 275, 3);
  EXPECT_EQ(finding.left_blobs.blobs.size(), 3U);
  EXPECT_GE(finding.left.patch.scale, 2);
}

TEST(MarkDetector, SaysThatTheBorderCutsAMark) {
  Pair pair;
  pair.draw({620.0, 150.0, kEdge, 0.0, kRed, 0.1}, kDisparity);
  const Finding finding = detect(pair.expose(), {mark("red", 345.0, 15.0)}).marks[0];
  EXPECT_TRUE(finding.left.seen);
  EXPECT_TRUE(finding.left.clipped);
  EXPECT_FALSE(finding.right.clipped);
}

TEST(MarkDetector, TellsHowFarAMarkStandsOffFromItsSurroundings) {
  const auto separability_on = [](const Colour& background) {
    Pair pair;
    pair.left.fill(0, 0, 640, 480, background);
    pair.right.fill(0, 0, 640, 480, background);
    pair.draw({320.0, 150.0, kEdge, 0.0, kRed, 0.1}, kDisparity);
    return detect(pair.expose(), {mark("red", 345.0, 15.0)}).marks[0].separability;
  };
  EXPECT_GT(separability_on(kGrey), 0.95);
  EXPECT_LT(separability_on({60.0, 75.0, 130.0}), separability_on(kGrey));
}

TEST(MarkDetector, WorksOnASinglePicture) {
  Picture picture(101, 77, kGrey);
  picture.draw({50.2, 40.1, 30.0, 0.2, kRed, 0.0});
  picture.expose();
  Input input;
  input.left = picture.view();
  const Finding finding = detect(input, {mark("red", 345.0, 15.0)}).marks[0];
  EXPECT_EQ(finding.reason, "");
  EXPECT_NEAR(finding.left.shape.u, 50.2, 0.05);
  EXPECT_FALSE(finding.right.seen);
}

TEST(MarkDetector, SurvivesImagesOfAnySizeAndOneColour) {
  for (const int width : {1, 2, 3, 63, 65}) {
    for (const int height : {1, 2, 17}) {
      for (const Colour& colour : {Colour{0, 0, 0}, Colour{255, 255, 255}, kRed}) {
        Picture picture(width, height, colour);
        picture.expose();
        Input input;
        input.left = picture.view();
        input.right = picture.view();
        Parameters parameters;
        parameters.views.min_area = 1;
        State state;
        const Output output = MarkDetector(four_marks(), parameters).step(input, state);
        ASSERT_EQ(output.marks.size(), 4U);
        for (const Finding& finding : output.marks) {
          EXPECT_TRUE(std::isfinite(finding.separability));
          EXPECT_TRUE(std::isfinite(finding.left.shape.m_uu));
        }
        EXPECT_EQ(output.marks[0].reason, "no pixel of its colour in either image");
      }
    }
  }
}

TEST(MarkDetector, SaysThatAnImageFullOfTheMarkIsCut) {
  Picture picture(120, 90, kRed);
  picture.expose(1.0, 3.0);
  Input input;
  input.left = picture.view();
  const Finding finding = detect(input, {mark("red", 345.0, 15.0)}).marks[0];
  EXPECT_TRUE(finding.left.clipped);
  EXPECT_EQ(finding.left.shape.area, 120.0 * 90.0);
  EXPECT_EQ(finding.separability, 0.0) << "there is nothing around it";
}

TEST(MarkDetector, SurvivesThousandsOfBlobs) {
  Pair pair;
  for (int v = 2; v < 470; v += 6) {
    for (int u = 2; u < 630; u += 6) {
      pair.left.fill(u, v, 4, 4, kRed);
      pair.right.fill(u, v, 4, 4, kRed);
    }
  }
  Parameters parameters;
  parameters.views.min_area = 4;
  State state;
  const Output output = MarkDetector({mark("red", 345.0, 15.0)}, parameters).step(pair.expose(1.0, 0.0), state);
  EXPECT_EQ(output.marks[0].left_blobs.blobs.size(), 1024U);
}

TEST(MarkDetector, RefusesWhatItCannotWorkOn) {
  State state;
  const MarkDetector detector(four_marks(), {});
  EXPECT_THROW(detector.step(Input{}, state), std::invalid_argument);
  Picture small(10, 10, kGrey);
  Picture large(12, 10, kGrey);
  small.expose();
  large.expose();
  Input input;
  input.left = small.view();
  input.right = large.view();
  EXPECT_THROW(detector.step(input, state), std::invalid_argument);
  EXPECT_THROW(MarkDetector({}, {}), std::invalid_argument);
}

}  // namespace
}  // namespace markservo::mark_detector
