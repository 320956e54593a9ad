#include <gtest/gtest.h>

#include "services/camera-check/pair/pair_geometry.hpp"
#include "tests/unit/camera-check/scene_pair.hpp"

namespace markservo::camera_check {
namespace {

class Pair : public ::testing::TestWithParam<unsigned> {
 protected:
  static PairGeometry geometry(const cv::Mat& left, const cv::Mat& right) {
    return geometry_of(match_corners(grey_of(left), grey_of(right)), 0.0);
  }

  scenes::StereoPair scene_ = scene_pair(0.6, GetParam());
};

TEST_P(Pair, AsCalibratedHasItsRowsTogetherAndAllInFront) {
  const PairGeometry found = geometry(scene_.left, scene_.right);
  EXPECT_GE(found.num_matches, 40);
  EXPECT_NEAR(found.rows.worst_px(), 0.0, 0.2);
  EXPECT_LT(found.behind_share, 0.05);
  EXPECT_FALSE(found.is_one_picture);
}

TEST_P(Pair, ThatIsExchangedHasAllBehindInfinity) {
  const PairGeometry found = geometry(scene_.right, scene_.left);
  EXPECT_GE(found.num_matches, 40);
  EXPECT_GT(found.behind_share, 0.95);
}

TEST_P(Pair, TellsByHowMuchItsRowsAreOff) {
  for (const double down_px : {-6.0, -1.5, 0.5, 2.3, 12.0}) {
    const PairGeometry found = geometry(scene_.left, moved(scene_.right, down_px));
    EXPECT_NEAR(found.rows.middle_px, down_px, 0.2);
    ASSERT_GE(found.num_matches, 40) << down_px;
  }
}

TEST_P(Pair, TellsThatACameraIsRolled) {
  const PairGeometry found = geometry(scene_.left, moved(scene_.right, 0.0, 1.0));
  ASSERT_TRUE(found.rows.left_px && found.rows.right_px);
  // Turned counter-clockwise about the middle: what is on the left comes down, what is on the right goes up, by 1.7 px
  // on 100.
  EXPECT_GT(*found.rows.left_px - *found.rows.right_px, 1.5);
  EXPECT_GT(std::abs(found.rows.worst_px()), 1.0);
}

TEST_P(Pair, OfOneCameraNamedTwiceIsOnePicture) {
  EXPECT_TRUE(geometry(scene_.left, scene_.left).is_one_picture);
}

TEST_P(Pair, OfLargePicturesIsMeasuredInTheirPixels) {
  cv::Mat left;
  cv::Mat right;
  cv::resize(scene_.left, left, cv::Size(), 3.0, 3.0, cv::INTER_CUBIC);
  cv::resize(moved(scene_.right, 2.0), right, cv::Size(), 3.0, 3.0, cv::INTER_CUBIC);
  EXPECT_NEAR(geometry(left, right).rows.middle_px, 6.0, 0.6);
}

INSTANTIATE_TEST_SUITE_P(Scenes, Pair, ::testing::Values(1U, 2U, 3U));

TEST(PairOfAnything, IsTakenWithoutHarm) {
  for (const cv::Size size : {cv::Size(1, 1), cv::Size(16, 9), cv::Size(640, 480)}) {
    const cv::Mat black(size, CV_8UC3, cv::Scalar::all(0));
    EXPECT_EQ(geometry_of(match_corners(grey_of(black), grey_of(black)), 0.0).num_matches, 0);
  }
}

TEST(PairOfAnything, WithNothingInCommonHardlyMatches) {
  const cv::Mat left = grey_of(scene_pair(0.6, 1).left);
  cv::Mat noise(left.size(), CV_8U);
  cv::RNG(3).fill(noise, cv::RNG::UNIFORM, 0, 255);
  EXPECT_LT(match_corners(left, noise).matches.size(), 5U);
}

TEST(Disparity, IsThatOfTheCalibration) {
  PairMatches found;
  for (int i = 0; i < 30; ++i) found.matches.push_back({cv::Point2d(100 + i, 50), cv::Point2d(110 + i, 50)});
  EXPECT_DOUBLE_EQ(geometry_of(found, 0.0).behind_share, 1.0);
  // The right camera's principal point is 20 px further right: these points are in front of it.
  EXPECT_DOUBLE_EQ(geometry_of(found, -20.0).behind_share, 0.0);
}

}  // namespace
}  // namespace markservo::camera_check
