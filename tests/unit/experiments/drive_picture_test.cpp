#include "tests/experiments/drive_picture.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <markservo/TaskState.hpp>
#include <opencv2/imgcodecs.hpp>
#include <string>

#include "tests/unit/bus/memq_bus.hpp"

namespace markservo::experiments {
namespace {

constexpr int kLegendHeight = 30;    // px
constexpr int kPixelsPerTenth = 56;  // of a metre
constexpr unsigned char kDark = 60;  // grey level; the paper is light

// The longest row of dark pixels in the picture's legend, px.
int longest_bar(const cv::Mat& grey) {
  int longest = 0;
  for (int row = 0; row < std::min(kLegendHeight, grey.rows); ++row) {
    int length = 0;
    for (int column = 0; column < grey.cols; ++column) {
      length = grey.at<unsigned char>(row, column) < kDark ? length + 1 : 0;
      longest = std::max(longest, length);
    }
  }
  return longest;
}

TEST(DrivePicture, HasAScaleOfATenthOfAMetre) {
  bus::Bus bus(bus::memq_parameters("experiment"));
  auto truths = bus.advertise(channels::kSimBaseTruth);
  DriveWatch watch(bus);
  watch.observe(TaskState::DRIVE);
  SimBaseTruth truth{};
  for (int i = 0; i < 10; ++i) {
    truth.utime = 20'000 * (i + 1);
    truth.pose.y = 0.1 * i;
    truths.publish(truth);
    settle(bus);
  }
  const std::string path =
      std::filesystem::temp_directory_path() / ("drive_picture_test." + std::to_string(getpid()) + ".png");
  write_drive_picture(path, robot::load_robot_description(MARKSERVO_SOURCE_DIR "/config/robot.yaml"), watch, {}, {});
  const cv::Mat picture = cv::imread(path, cv::IMREAD_GRAYSCALE);
  std::filesystem::remove(path);
  ASSERT_FALSE(picture.empty());
  EXPECT_EQ(longest_bar(picture), kPixelsPerTenth + 1) << "both ends are drawn";
}

}  // namespace
}  // namespace markservo::experiments
