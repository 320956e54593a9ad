#include "services/stereo-camera/files/orientation.hpp"

#include <gtest/gtest.h>

namespace markservo::stereo_camera {
namespace {

constexpr std::int32_t kOne = 65536;  // in the matrix's 16.16 fixed point

// 1 2
// 3 4
// 5 6
const cv::Mat kPicture = (cv::Mat_<std::uint8_t>(3, 2) << 1, 2, 3, 4, 5, 6);

// A pixel (x, y) is shown at (a x + c y, b x + d y).
cv::Mat shown(int a, int b, int c, int d) {
  return make_upright(kPicture, orientation_of({a * kOne, b * kOne, 0, c * kOne, d * kOne, 0, 0, 0, 1 << 30}));
}

::testing::AssertionResult same(const cv::Mat& seen, const cv::Mat& expected) {
  if (seen.size() == expected.size() && cv::norm(seen, expected, cv::NORM_INF) == 0.0) {
    return ::testing::AssertionSuccess();
  }
  return ::testing::AssertionFailure() << seen << " instead of " << expected;
}

cv::Mat picture(int rows, int cols, std::vector<std::uint8_t> values) {
  return cv::Mat(values, true).reshape(1, rows).colRange(0, cols).clone();
}

TEST(Orientation, LeavesAnUprightPictureAsItIs) {
  EXPECT_TRUE(same(shown(1, 0, 0, 1), kPicture));
  EXPECT_TRUE(same(make_upright(kPicture, {}), kPicture));
}

TEST(Orientation, TurnsByQuarters) {
  EXPECT_TRUE(same(shown(0, -1, 1, 0), picture(2, 3, {2, 4, 6, 1, 3, 5}))) << "against the clock: x goes up";
  EXPECT_TRUE(same(shown(0, 1, -1, 0), picture(2, 3, {5, 3, 1, 6, 4, 2}))) << "with the clock: x goes down";
  EXPECT_TRUE(same(shown(-1, 0, 0, -1), picture(3, 2, {6, 5, 4, 3, 2, 1}))) << "half a turn";
}

TEST(Orientation, MirrorsToo) {
  EXPECT_TRUE(same(shown(-1, 0, 0, 1), picture(3, 2, {2, 1, 4, 3, 6, 5})));
  EXPECT_TRUE(same(shown(1, 0, 0, -1), picture(3, 2, {5, 6, 3, 4, 1, 2})));
  EXPECT_TRUE(same(shown(0, 1, 1, 0), picture(2, 3, {1, 3, 5, 2, 4, 6})));
  EXPECT_TRUE(same(shown(0, -1, -1, 0), picture(2, 3, {6, 4, 2, 5, 3, 1})));
}

TEST(Orientation, LeavesTheGivenPictureUntouched) {
  const cv::Mat given = kPicture.clone();
  cv::Mat upright = make_upright(given, {false, true, true});
  upright.setTo(0);
  make_upright(given, {}).setTo(0);
  EXPECT_TRUE(same(given, kPicture));
}

}  // namespace
}  // namespace markservo::stereo_camera
