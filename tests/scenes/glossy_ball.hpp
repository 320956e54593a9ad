#pragma once

// A glossy ball before a wall, by dichromatic reflection: shade scales the body's colour, a highlight adds the lamp's.

#include <Eigen/Core>
#include <cstdint>
#include <opencv2/core.hpp>

#include "services/mark-detector/colour/hue.hpp"

namespace markservo::scenes {

using mark_detector::Bgr;

struct GlossyBall {
  int width = 320;   // px, of the picture
  int height = 240;  // px
  double u = 160.0;  // px, the ball's centre
  double v = 120.0;
  double radius = 30.0;                    // px
  Bgr body{};                              // levels in full light
  Bgr wall{};                              // levels in the picture's middle
  Eigen::Vector2d wall_slope{0.0, 0.0};    // of the wall's light, share from edge to edge to the right and down
  Eigen::Vector3d to_lamp{0.0, 0.0, 1.0};  // unit vector: right, down, towards the camera
  double ambient = 0.3;                    // of full light, in the shade
  Bgr lamp{1.0, 1.0, 1.0};                 // gains of the channels, white 1
  double highlight_share = 0.0;            // of the ball's box that reflects the lamp by half its peak or more
  double highlight_peak = 1.0;             // of white
  double highlight_sharpness = 1.0;        // 1: rough, its rim falls off as a Gaussian; 3: polished
  double blur_px = 0.6;                    // sigma
  double noise = 3.0;                      // levels, sigma
};

struct BallPicture {
  cv::Mat image;  // 8-bit BGR
  cv::Mat mask;   // 255 where the ball covers half of the pixel or more
  cv::Rect box;   // of the mask
};

BallPicture draw_ball(const GlossyBall& ball, std::uint64_t seed);

}  // namespace markservo::scenes
