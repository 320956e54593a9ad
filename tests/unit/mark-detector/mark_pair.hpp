#pragma once

// Four marks before two cameras.

#include <string>
#include <vector>

#include "services/mark-detector/mark_detector.hpp"
#include "tests/unit/mark-detector/synthetic_scene.hpp"

namespace markservo::mark_detector::test {

inline robot::MarkDescription mark(const std::string& name, double hue_min, double hue_max) {
  robot::MarkDescription mark;
  mark.name = name;
  mark.size = 0.025;
  mark.colour = {hue_min, hue_max, 0.45, 1.0, 0.2, 1.0};
  return mark;
}

inline std::vector<robot::MarkDescription> four_marks() {
  auto hand = mark("hand", 95.0, 150.0);
  hand.role = robot::MarkRole::kManipulator;
  hand.size = 0.020;
  return {hand, mark("red", 345.0, 15.0), mark("yellow", 40.0, 72.0), mark("blue", 200.0, 245.0)};
}

inline geometry::StereoCamera cameras() {
  return {784.0, 784.0, 319.5, 319.5, 239.5, 0.065};
}

// A pair of pictures in which things stand at a disparity.
struct Pair {
  Picture left{640, 480, kGrey};
  Picture right{640, 480, kGrey};

  void draw(Square square, double disparity) {
    left.draw(square);
    square.u -= disparity;
    right.draw(square);
  }
  Input expose(double gain = 1.0, double sigma = 3.0, unsigned seed = 1) {
    left.expose(gain, sigma, seed);
    right.expose(gain, sigma, seed + 1000);
    Input input;
    input.left = left.view();
    input.right = right.view();
    input.stereo = cameras();
    return input;
  }
};

inline constexpr double kDisparity = 204.0;                  // px, 250 mm
inline constexpr double kEdge = kDisparity * 0.025 / 0.065;  // px, of a mark of 25 mm
inline constexpr double kHandEdge = kDisparity * 0.020 / 0.065;
inline constexpr double kMaskError = 0.5;  // px, of a mask's centroid: an edge pixel counts whole or not at all

}  // namespace markservo::mark_detector::test
