#include "services/mark-detector/views/mark_selection.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace markservo::mark_detector {
namespace {

Blob box(int x, int y, int width, int height) {
  Blob blob;
  std::vector<PixelRun> runs;
  for (int v = y; v < y + height; ++v) runs.push_back({v, x, x + width});
  blob.shape = shape_of(runs);
  return blob;
}

SelectionContext context() {
  SelectionContext context;
  context.image_width = 640;
  context.image_height = 480;
  return context;
}

TEST(Selection, TakesTheLargestConsistentPair) {
  const std::vector<Blob> left = {box(400, 200, 60, 60), box(300, 300, 30, 30)};
  const std::vector<Blob> right = {box(200, 201, 60, 60), box(150, 300, 30, 30)};
  const Selection selection = select_pair(left, right, context(), std::nullopt, {});
  EXPECT_EQ(selection.left, 0U);
  EXPECT_EQ(selection.right, 0U);
  EXPECT_TRUE(selection.reason.empty());
}

TEST(Selection, ADistractorInOneImageDoesNotWin) {
  const std::vector<Blob> left = {box(20, 50, 120, 120), box(400, 200, 60, 60)};
  const std::vector<Blob> right = {box(200, 201, 60, 60)};
  const Selection selection = select_pair(left, right, context(), std::nullopt, {});
  EXPECT_EQ(selection.left, 1U);
  EXPECT_EQ(selection.right, 0U);
}

TEST(Selection, TakesThePairNearestToWhereTheMarkWas) {
  const std::vector<Blob> left = {box(400, 200, 60, 60), box(300, 300, 50, 50)};
  const std::vector<Blob> right = {box(200, 200, 60, 60), box(120, 300, 50, 50)};
  const PairPlace last{330.0, 320.0, 150.0};
  const Selection selection = select_pair(left, right, context(), last, {});
  EXPECT_EQ(selection.left, 1U);
  EXPECT_EQ(selection.right, 1U);
}

TEST(Selection, OfOneImageOnlyTakesItsNearestOrLargest) {
  const std::vector<Blob> left = {box(400, 200, 60, 60), box(300, 300, 50, 50)};
  const Selection largest = select_pair(left, {}, context(), std::nullopt, {});
  EXPECT_EQ(largest.left, 0U);
  EXPECT_FALSE(largest.right);
  const Selection nearest = select_pair(left, {}, context(), PairPlace{330.0, 320.0, 150.0}, {});
  EXPECT_EQ(nearest.left, 1U);
  EXPECT_EQ(select_pair({}, left, context(), PairPlace{0.0, 320.0, 330.0}, {}).right, 1U);
}

TEST(Selection, SaysWhyNoTwoBlobsAgree) {
  const auto reason = [](const Blob& left, const Blob& right, const SelectionContext& where) {
    const Selection selection = select_pair({left}, {right}, where, std::nullopt, {});
    EXPECT_FALSE(selection.left);
    EXPECT_FALSE(selection.right);
    return selection.reason;
  };
  EXPECT_EQ(reason(box(400, 200, 60, 60), box(200, 240, 60, 60), context()),
            "the blobs' rows differ by 40.0 px, allowed 6.0 px");
  EXPECT_EQ(reason(box(200, 200, 60, 60), box(210, 200, 60, 60), context()),
            "the blobs' disparity is -10.0 px, allowed above 0 px");
  EXPECT_EQ(reason(box(400, 200, 60, 60), box(200, 210, 60, 40), context()),
            "the blobs' heights are 60 and 40 px, allowed ratio 1.35");
  EXPECT_EQ(reason(box(400, 200, 60, 60), box(200, 200, 30, 60), context()),
            "the blobs' areas are 3600 and 1800 px, allowed ratio 1.80");
  SelectionContext sized = context();
  sized.size_per_baseline = 0.5;
  EXPECT_EQ(reason(box(400, 200, 20, 20), box(200, 200, 20, 20), sized),
            "the blobs have 400 px where the mark's size and their disparity of 200 px make 10000 px, "
            "allowed 20 to 200 %");
}

TEST(Selection, MeasuresDisparityFromEachCamerasOwnPrincipalPoint) {
  SelectionContext shifted = context();
  shifted.principal_offset = -50.0;  // toed-in cameras, rectified
  EXPECT_TRUE(inconsistency(box(200, 200, 60, 60).shape, box(210, 200, 60, 60).shape, shifted, {}).empty());
}

TEST(Selection, KnowsTheMarksSizeFromBaselineAndDisparity) {
  SelectionContext sized = context();
  sized.size_per_baseline = 0.025 / 0.065;
  const double disparity = 200.0;
  const int edge = static_cast<int>(disparity * 0.025 / 0.065);
  EXPECT_TRUE(inconsistency(box(400, 200, edge, edge).shape, box(200, 200, edge, edge).shape, sized, {}).empty());
  EXPECT_FALSE(inconsistency(box(400, 200, 30, 30).shape, box(200, 200, 30, 30).shape, sized, {}).empty());
}

TEST(Selection, DoesNotJudgeTheSizeOfWhatTheBorderCuts) {
  EXPECT_TRUE(inconsistency(box(400, 200, 60, 60).shape, box(0, 200, 20, 60).shape, context(), {}).empty());
}

TEST(Selection, IsBoundedForManyBlobs) {
  std::vector<Blob> many;
  many.reserve(1000);
  for (int i = 0; i < 1000; ++i) many.push_back(box(5 + 15 * (i % 40), 5 + 15 * (i / 40), 9, 9));
  const Selection selection = select_pair(many, many, context(), std::nullopt, {});
  ASSERT_TRUE(selection.left);
  EXPECT_LT(*selection.left, 32U);
}

TEST(Clipping, IsTouchingTheBorder) {
  EXPECT_FALSE(is_clipped(box(1, 1, 10, 10).shape, 12, 12));
  EXPECT_TRUE(is_clipped(box(0, 1, 10, 10).shape, 12, 12));
  EXPECT_TRUE(is_clipped(box(1, 0, 10, 10).shape, 12, 12));
  EXPECT_TRUE(is_clipped(box(2, 1, 10, 10).shape, 12, 12));
  EXPECT_TRUE(is_clipped(box(1, 2, 10, 10).shape, 12, 12));
}

}  // namespace
}  // namespace markservo::mark_detector
