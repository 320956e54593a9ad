#include "services/mark-detector/blobs/blobs.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <opencv2/imgproc.hpp>
#include <string>
#include <vector>

#include "services/mark-detector/blobs/hole_filler.hpp"

namespace markservo::mark_detector {
namespace {

BitMask mask_of(const std::vector<std::string>& rows) {
  BitMask mask(static_cast<int>(rows[0].size()), static_cast<int>(rows.size()));
  for (int v = 0; v < mask.height(); ++v) {
    for (int u = 0; u < mask.width(); ++u) {
      if (rows[static_cast<std::size_t>(v)][static_cast<std::size_t>(u)] == '#') mask.set_run(v, u, u + 1);
    }
  }
  return mask;
}

BitMask mask_of(const cv::Mat& image) {
  BitMask mask(image.cols, image.rows);
  for (int v = 0; v < image.rows; ++v) {
    for (int u = 0; u < image.cols; ++u) mask.set(u, v, image.at<std::uint8_t>(v, u) != 0);
  }
  return mask;
}

TEST(Blobs, JoinOverCornersOrNotAsAsked) {
  const BitMask mask = mask_of({"##..", "##..", "..##", "..##"});
  EXPECT_EQ(find_blobs(mask, {}).blobs.size(), 1U);
  BlobParameters four;
  four.connectivity = Connectivity::kFour;
  EXPECT_EQ(find_blobs(mask, four).blobs.size(), 2U);
}

TEST(Blobs, JoinArmsThatMeetLate) {
  const BitMask mask = mask_of({"#...#.#", "#...#.#", "##.##.#", ".###..#", "......#"});
  const BlobList list = find_blobs(mask, {});
  ASSERT_EQ(list.blobs.size(), 2U);
  EXPECT_EQ(list.blobs[0].shape.area, 11.0);
  EXPECT_EQ(list.blobs[1].shape.area, 5.0);
}

TEST(Blobs, AreOpenCvsComponentsWithItsMoments) {
  for (const auto connectivity : {Connectivity::kFour, Connectivity::kEight}) {
    for (const int width : {1, 64, 65, 150}) {
      for (const double share : {0.3, 0.5, 0.6}) {
        cv::Mat image(83, width, CV_32FC1);
        cv::RNG random(static_cast<std::uint64_t>(width));
        random.fill(image, cv::RNG::UNIFORM, 0.0, 1.0);
        cv::Mat binary = (image < share) / 255;
        cv::Mat labels;
        cv::Mat stats;
        cv::Mat centroids;
        const int n = cv::connectedComponentsWithStats(binary, labels, stats, centroids,
                                                       connectivity == Connectivity::kFour ? 4 : 8);
        BlobParameters parameters;
        parameters.connectivity = connectivity;
        parameters.max_blobs = 100000;
        const BlobList list = find_blobs(mask_of(binary), parameters);
        ASSERT_EQ(static_cast<int>(list.blobs.size()), n - 1);
        for (const Blob& blob : list.blobs) {
          const PixelRun& first = list.runs_of(blob).front();
          const int label = labels.at<int>(first.v, first.begin);
          EXPECT_EQ(blob.shape.x, stats.at<int>(label, cv::CC_STAT_LEFT));
          EXPECT_EQ(blob.shape.y, stats.at<int>(label, cv::CC_STAT_TOP));
          EXPECT_EQ(blob.shape.width, stats.at<int>(label, cv::CC_STAT_WIDTH));
          EXPECT_EQ(blob.shape.height, stats.at<int>(label, cv::CC_STAT_HEIGHT));
          EXPECT_EQ(blob.shape.area, stats.at<int>(label, cv::CC_STAT_AREA));
          const cv::Moments m = cv::moments(labels == label, true);
          EXPECT_NEAR(blob.shape.u, m.m10 / m.m00, 1e-9);
          EXPECT_NEAR(blob.shape.v, m.m01 / m.m00, 1e-9);
          EXPECT_NEAR(blob.shape.m_uu, m.mu20 / m.m00, 1e-6);
          EXPECT_NEAR(blob.shape.m_uv, m.mu11 / m.m00, 1e-6);
          EXPECT_NEAR(blob.shape.m_vv, m.mu02 / m.m00, 1e-6);
        }
      }
    }
  }
}

TEST(Blobs, ComeTheLargestFirstAndEqualOnesFromTopLeft) {
  const BlobList list = find_blobs(mask_of({"##...##", "##...##", "...#...", ".......", "###.###", "###.###"}), {});
  std::vector<double> areas;
  for (const Blob& blob : list.blobs) areas.push_back(blob.shape.area);
  EXPECT_EQ(areas, (std::vector<double>{6.0, 6.0, 4.0, 4.0, 1.0}));
  EXPECT_LT(list.blobs[0].shape.x, list.blobs[1].shape.x);
  EXPECT_LT(list.blobs[2].shape.x, list.blobs[3].shape.x);
}

TEST(Blobs, TellTheLargestEvenIfItIsTooSmall) {
  BlobParameters parameters;
  parameters.min_area = 7;
  const BlobList list = find_blobs(mask_of({"###....", "###...#"}), parameters);
  EXPECT_TRUE(list.blobs.empty());
  EXPECT_EQ(list.largest_area, 6);
}

TEST(Blobs, AreBoundedInNumber) {
  BitMask mask(999, 999);
  for (int v = 0; v < 999; v += 2) {
    for (int u = 0; u < 999; u += 2) mask.set_run(v, u, u + 1);
  }
  const BlobList list = find_blobs(mask, {});
  EXPECT_EQ(list.blobs.size(), BlobParameters{}.max_blobs);
  EXPECT_EQ(list.largest_area, 1);
}

TEST(Blobs, OfNothingAreNone) {
  EXPECT_TRUE(find_blobs(BitMask(), {}).blobs.empty());
  EXPECT_TRUE(find_blobs(BitMask(70, 3), {}).blobs.empty());
  EXPECT_EQ(shape_of(RunSpan()).area, 0.0);
}

std::vector<PixelRun> filled(const BlobList& list, const Blob& blob, std::int64_t max_hole) {
  std::vector<PixelRun> runs;
  HoleFiller().fill(list.runs_of(blob), max_hole, runs);
  return runs;
}

TEST(Holes, AreFilledUpToTheLimit) {
  const BitMask mask = mask_of({"########", "#.#...##", "###...##", "########", "#.######"});
  const BlobList list = find_blobs(mask, {});
  const Blob blob = list.blobs.at(0);
  EXPECT_EQ(blob.shape.area, 32.0);
  EXPECT_EQ(shape_of(filled(list, blob, 0)).area, 32.0);
  EXPECT_EQ(shape_of(filled(list, blob, 5)).area, 33.0);
  const std::vector<PixelRun> all = filled(list, blob, 6);
  EXPECT_EQ(shape_of(all).area, 39.0) << "the notch at the bottom is no hole";
  EXPECT_EQ(all.size(), 6U) << "runs are joined";
}

TEST(Holes, DoNotLeakOverCorners) {
  const BitMask mask = mask_of({".##.", "#..#", ".##.", "...."});
  const BlobList list = find_blobs(mask, {});
  const Blob blob = list.blobs.at(0);
  EXPECT_EQ(shape_of(filled(list, blob, 2)).area, 8.0);
}

TEST(Merge, TakesAllBlobsAsOne) {
  std::vector<PixelRun> runs;
  merge(find_blobs(mask_of({"##..#", ".....", "#...#"}), {}), runs);
  const Shape all = shape_of(runs);
  EXPECT_EQ(all.area, 5.0);
  EXPECT_EQ(all.width, 5);
  EXPECT_EQ(all.height, 3);
  EXPECT_TRUE(std::is_sorted(runs.begin(), runs.end(), [](const PixelRun& a, const PixelRun& b) {
    return a.v != b.v ? a.v < b.v : a.begin < b.begin;
  }));
}

}  // namespace
}  // namespace markservo::mark_detector
