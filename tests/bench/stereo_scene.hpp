#pragma once

// Stereo pairs whose truth is known: printed square marks on cards before a cluttered wall, with noise.

#include <Eigen/Core>
#include <cstdint>
#include <opencv2/core.hpp>
#include <string>
#include <vector>

#include "common/robot/robot_description.hpp"

namespace markservo::bench {

struct MarkTruth {
  std::string name;
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();   // m, in C
  Eigen::Vector3d outward = Eigen::Vector3d::Zero();  // unit normal of its plane, away from the cameras

  // u_left - u_right of the mark's plane at a place of the left image, px: a plane's disparity is linear.
  double disparity(const geometry::StereoCamera& camera, double u, double v) const;
};

struct StereoPair {
  cv::Mat left;   // 8-bit BGR
  cv::Mat right;  // likewise
  std::vector<MarkTruth> marks;
};

struct SceneParameters {
  int num_pairs = 64;    // 118 MB at 640 x 480: each pair has left the caches before it comes again
  int num_layouts = 8;   // different scenes, each for a while; the pairs of one differ by their noise
  double sigma = 3.0;    // grey levels of noise
  double blur_px = 0.6;  // sigma of the lens
  unsigned seed = 1;
};

// Pairs of the robot's image size that show all of `marks`, at 220 to 300 mm, in the middle of their colour intervals.
// Every surface is sampled 4 x 4 times a pixel and averaged by area, so that no interpolation takes part.
std::vector<StereoPair> render_pairs(const robot::CameraDescription& cameras,
                                     const std::vector<robot::MarkDescription>& marks,
                                     const SceneParameters& parameters);

}  // namespace markservo::bench
