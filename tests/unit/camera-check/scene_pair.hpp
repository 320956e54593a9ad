#pragma once

// A drawn pair with the robot's marks before a cluttered wall.

#include <map>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>
#include <utility>

#include "common/robot/robot_description.hpp"
#include "tests/scenes/stereo_scene.hpp"

namespace markservo::camera_check {

// As in focus by default, with 3 levels of noise. Each is drawn once, which takes a second.
inline const scenes::StereoPair& scene_pair(double blur_px = 0.6, unsigned seed = 1) {
  static std::map<std::pair<double, unsigned>, scenes::StereoPair> drawn;
  const auto found = drawn.find({blur_px, seed});
  if (found != drawn.end()) return found->second;
  const robot::RobotDescription robot = robot::load_robot_description(MARKSERVO_SOURCE_DIR "/config/robot.yaml");
  scenes::SceneParameters parameters;
  parameters.num_pairs = 1;
  parameters.num_layouts = 1;
  parameters.blur_px = blur_px;
  parameters.seed = seed;
  return drawn[{blur_px, seed}] = scenes::render_pairs(robot.cameras, robot.marks, parameters).front();
}

inline cv::Mat grey_of(const cv::Mat& bgr) {
  cv::Mat grey;
  cv::cvtColor(bgr, grey, cv::COLOR_BGR2GRAY);
  return grey;
}

// The picture as a camera sees it that was moved by so much (px, down) and rolled about its middle by so much
// (degrees).
inline cv::Mat moved(const cv::Mat& picture, double down_px, double roll_deg = 0.0) {
  cv::Mat way = cv::getRotationMatrix2D(
      cv::Point2f(0.5F * static_cast<float>(picture.cols - 1), 0.5F * static_cast<float>(picture.rows - 1)), roll_deg,
      1.0);
  way.at<double>(1, 2) += down_px;
  cv::Mat result;
  cv::warpAffine(picture, result, way, picture.size(), cv::INTER_CUBIC, cv::BORDER_REFLECT);
  return result;
}

}  // namespace markservo::camera_check
