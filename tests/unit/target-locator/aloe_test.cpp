// A real plant: Debian's opencv-doc holds a stereo pair of an aloe with its true disparities.

#include <gtest/gtest.h>

#include <cmath>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <set>
#include <string>

#include "services/target-locator/mark_locator.hpp"

namespace markservo::target_locator {
namespace {

const std::string kFolder = "/usr/share/doc/opencv-doc/examples/data/";

struct Picture {
  cv::Mat3b image;
  std::vector<std::uint8_t> mask;
  View view;
};

// The largest green blob of the picture, in a patch as large as the picture.
Picture leaves(const std::string& file) {
  Picture picture;
  picture.image = cv::imread(kFolder + file, cv::IMREAD_COLOR);
  if (picture.image.empty()) return picture;
  const int width = picture.image.cols;
  const int height = picture.image.rows;
  cv::Mat3b hsv;
  cv::cvtColor(picture.image, hsv, cv::COLOR_BGR2HSV);
  cv::Mat1b green;
  cv::inRange(hsv, cv::Scalar(30, 50, 25), cv::Scalar(90, 255, 255), green);
  cv::morphologyEx(green, green, cv::MORPH_OPEN, cv::Mat::ones(3, 3, CV_8U));
  cv::Mat1i labels;
  cv::Mat1i stats;
  cv::Mat1d centroids;
  const int count = cv::connectedComponentsWithStats(green, labels, stats, centroids, 8);
  int largest = 1;
  for (int k = 2; k < count; ++k) {
    if (stats(k, cv::CC_STAT_AREA) > stats(largest, cv::CC_STAT_AREA)) largest = k;
  }
  const int stride = (width + 7) / 8;
  picture.mask.assign(static_cast<std::size_t>(stride * height), 0);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      if (labels(y, x) != largest) continue;
      auto& bits = picture.mask[static_cast<std::size_t>(y * stride + x / 8)];
      bits = static_cast<std::uint8_t>(bits | (1U << (x % 8)));
    }
  }
  View& view = picture.view;
  view.seen = true;
  view.clipped = true;  // the leaves leave the picture
  view.x = stats(largest, cv::CC_STAT_LEFT);
  view.y = stats(largest, cv::CC_STAT_TOP);
  view.width = stats(largest, cv::CC_STAT_WIDTH);
  view.height = stats(largest, cv::CC_STAT_HEIGHT);
  view.patch.width = width;
  view.patch.height = height;
  return picture;
}

TEST(FreeSurface, MatchesTheLeavesOfARealPlant) {
  Picture left = leaves("aloeL.jpg");
  Picture right = leaves("aloeR.jpg");
  const cv::Mat1b truth = cv::imread(kFolder + "aloeGT.png", cv::IMREAD_GRAYSCALE);
  ASSERT_FALSE(left.image.empty() || right.image.empty() || truth.empty())
      << kFolder << "aloeL.jpg, aloeR.jpg or aloeGT.png cannot be read: install Debian's opencv-doc "
      << "(a minimal system leaves documentation out unless dpkg is told otherwise)";
  for (Picture* picture : {&left, &right}) {
    picture->view.patch.bgr = picture->image.data;
    picture->view.patch.mask = picture->mask.data();
  }
  MarkObservation observation;
  observation.left = left.view;
  observation.right = right.view;
  observation.surface = Surface::kFree;
  LocatorParameters parameters;
  parameters.features.max_features = 1500;
  parameters.free_surface.search.disparity_min = 40.0;
  parameters.free_surface.search.disparity_max = 215.0;
  const geometry::StereoCamera camera{3740.0, 3740.0, 640.5, 640.5, 554.5, 0.16};
  const Location found = locate_mark(observation, camera, parameters);
  EXPECT_EQ(found.status, Status::kClipped);

  int known = 0;
  int right_ones = 0;
  std::set<int> tiles;  // of 8 x 8
  for (const Match& match : found.matches) {
    const auto x = static_cast<int>(match.u_left);
    const auto y = static_cast<int>(match.v_left);
    const int disparity = truth(y, x);
    if (disparity == 0) continue;  // not measured there
    ++known;
    tiles.insert(y * 8 / truth.rows * 8 + x * 8 / truth.cols);
    if (std::abs(match.u_left - match.u_right - disparity) <= 1.0) ++right_ones;
  }
  const double share = static_cast<double>(right_ones) / known;
  RecordProperty("matches", known);
  RecordProperty("tiles", static_cast<int>(tiles.size()));
  RecordProperty("within_1_px", std::to_string(share));
  EXPECT_GE(known, 500);
  EXPECT_GE(tiles.size(), 20U);
  EXPECT_GE(share, 0.94);
}

}  // namespace
}  // namespace markservo::target_locator
