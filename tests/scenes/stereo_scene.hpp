#pragma once

// Stereo pairs whose truth is known: printed square marks on cards before a cluttered wall, with noise.

#include <opencv2/core.hpp>
#include <vector>

#include "common/robot/robot_description.hpp"
#include "tests/scenes/printed_surface.hpp"

namespace markservo::scenes {

struct StereoPair {
  cv::Mat left;                // 8-bit BGR
  cv::Mat right;               // likewise
  std::vector<Surface> marks;  // as asked for
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

}  // namespace markservo::scenes
