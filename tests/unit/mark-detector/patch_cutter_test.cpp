#include "services/mark-detector/patches/patch_cutter.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <numeric>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "services/mark-detector/picture/picture.hpp"

namespace markservo::mark_detector {
namespace {

std::vector<int> plan_scales(const std::vector<PatchRequest>& requests, const PatchParameters& parameters, int width,
                             int height) {
  PatchPlan plan;
  mark_detector::plan_scales(requests, parameters, width, height, plan);
  return plan.scales;
}

Shape box(int x, int y, int width, int height) {
  Shape shape;
  shape.x = x;
  shape.y = y;
  shape.width = width;
  shape.height = height;
  return shape;
}

TEST(PatchFrame, IsTheBoxAndItsMargin) {
  const PatchFrame frame = frame_patch(box(100, 50, 40, 30), {}, 1, 640, 480);
  EXPECT_EQ(frame.x, 92);
  EXPECT_EQ(frame.y, 42);
  EXPECT_EQ(frame.width, 56);
  EXPECT_EQ(frame.height, 46);
}

TEST(PatchFrame, CoversTheBoxWithWholePixelsInsideTheImage) {
  for (const auto& shape : {box(100, 50, 41, 33), box(0, 0, 7, 5), box(630, 470, 10, 10), box(0, 0, 640, 480)}) {
    for (int scale = 1; scale <= 7; ++scale) {
      const PatchFrame frame = frame_patch(shape, {}, scale, 640, 480);
      EXPECT_GE(frame.x, 0);
      EXPECT_GE(frame.y, 0);
      EXPECT_GE(frame.width, 1);
      EXPECT_LE(frame.x + frame.width * scale, 640);
      EXPECT_LE(frame.y + frame.height * scale, 480);
      if (shape.width == 640) continue;  // the last few columns may not fill a patch pixel
      EXPECT_LE(frame.x, shape.x);
      EXPECT_GE(frame.x + frame.width * scale, shape.x + shape.width);
      EXPECT_LE(frame.y, shape.y);
      EXPECT_GE(frame.y + frame.height * scale, shape.y + shape.height);
    }
  }
}

TEST(PatchFrame, OfAnImageOfOnePixelIsThatPixel) {
  const PatchFrame frame = frame_patch(box(0, 0, 1, 1), {}, 1, 1, 1);
  EXPECT_EQ(frame.width, 1);
  EXPECT_EQ(frame.height, 1);
}

TEST(PatchPlan, AveragesDownOnlyAsFarAsTheLimitAsks) {
  const auto scale_of = [](int edge, int limit) {
    PatchParameters parameters;
    parameters.limit = limit;
    parameters.budget = 100000000;
    return plan_scales({{box(0, 0, edge, edge), box(0, 0, edge, edge)}}, parameters, 2000, 2000).at(0);
  };
  EXPECT_EQ(scale_of(100, 128), 1);
  EXPECT_EQ(scale_of(200, 128), 2);
  EXPECT_EQ(scale_of(300, 128), 3);
  EXPECT_EQ(scale_of(2000, 4000), 1) << "a limit above the image leaves it whole";
}

TEST(PatchPlan, KeepsTheBudgetServesTheFirstBestAndTheLastToo) {
  const PatchParameters parameters;
  const std::vector<PatchRequest> requests(8, {box(300, 200, 90, 90), box(100, 200, 90, 90)});
  const std::vector<int> scales = plan_scales(requests, parameters, 640, 480);
  std::int64_t bytes = 0;
  for (std::size_t i = 0; i < scales.size(); ++i) {
    ASSERT_GT(scales[i], 0) << i;
    for (const Shape& shape : {requests[i].left, requests[i].right}) {
      bytes += frame_patch(shape, parameters, scales[i], 640, 480).bytes();
    }
  }
  EXPECT_EQ(scales[0], 1);
  EXPECT_GT(scales[7], 1);
  EXPECT_LE(bytes, parameters.budget);
}

TEST(PatchPlan, GivesNoneWhereNothingFits) {
  PatchParameters parameters;
  parameters.budget = 3;
  EXPECT_EQ(plan_scales({{box(0, 0, 9, 9), box(0, 0, 9, 9)}}, parameters, 20, 20), std::vector<int>{0});
}

Patch cut_patch(const ImageView& image, const Region& mark, const PatchFrame& frame) {
  Patch patch;
  PatchCutter().cut(image, mark, frame, patch);
  return patch;
}

Region region_of(const std::vector<PixelRun>& runs, int width, int height) {
  Region region;
  make_region(runs, shape_of(runs), 1, width, height, region);
  return region;
}

TEST(Patch, IsTheAreaAverageOfTheImage) {
  cv::Mat image(60, 90, CV_8UC3);
  cv::RNG random(5);
  random.fill(image, cv::RNG::UNIFORM, 0, 256);
  const Region nothing;
  for (const int scale : {1, 2, 3, 5}) {
    const PatchFrame frame{7, 4, scale, 12, 9};
    const Patch patch = cut_patch(view_of(image), nothing, frame);
    cv::Mat expected;
    cv::resize(image(cv::Rect(7, 4, 12 * scale, 9 * scale)), expected, cv::Size(12, 9), 0.0, 0.0, cv::INTER_AREA);
    const cv::Mat own(9, 12, CV_8UC3, const_cast<std::uint8_t*>(patch.bgr.data()));
    EXPECT_LE(cv::norm(own, expected, cv::NORM_INF), 1.0) << scale;
  }
}

TEST(Patch, HasTheMaskAsBitsWithRowsOfWholeBytes) {
  const cv::Mat image(20, 40, CV_8UC3, cv::Scalar::all(9));
  const Region mark = region_of({{6, 10, 20}, {7, 10, 20}}, 40, 20);
  const Patch patch = cut_patch(view_of(image), mark, {5, 5, 1, 18, 4});
  ASSERT_EQ(patch.mask.size(), 4U * 3U);
  for (std::size_t j = 0; j < 4; ++j) {
    for (std::size_t i = 0; i < 18; ++i) {
      const int bit = (patch.mask[j * 3 + i / 8] >> (i % 8)) & 1;
      EXPECT_EQ(bit == 1, (j == 1 || j == 2) && i >= 5 && i < 15) << i << " " << j;
    }
    EXPECT_EQ(patch.mask[j * 3 + 2] >> 2, 0) << "padding";
  }
}

TEST(Patch, TakesAPixelThatIsHalfMarkAsMark) {
  const cv::Mat image(8, 8, CV_8UC3, cv::Scalar::all(9));
  const Region mark = region_of({{2, 2, 4}, {4, 2, 3}}, 8, 8);
  const Patch patch = cut_patch(view_of(image), mark, {2, 2, 2, 1, 2});
  EXPECT_EQ(patch.mask, (std::vector<std::uint8_t>{1, 0}));
}

}  // namespace
}  // namespace markservo::mark_detector
