#pragma once

// Colours learned from drawn balls, and what the detector finds with them, against the truth.

#include <functional>
#include <opencv2/core.hpp>
#include <string>
#include <vector>

#include "common/robot/robot_description.hpp"
#include "tests/scenes/glossy_ball.hpp"

namespace markservo::scenes {

// A shaded glossy ball before a wall of near hue, and a box around it that is a little off. Near: up to 30 degrees in
// hue to either side, and paler, as far as a person still calls the colours different ones.
GlossyBall draw_glossy_ball(unsigned seed);

// One draw and what became of it.
struct LearningDraw {
  unsigned seed = 0;
  GlossyBall ball;
  cv::Rect box;     // as given, shifted
  cv::Point shift;  // px
  robot::ColourInterval learned;
  std::string failure;   // why nothing was learned; empty if something was
  std::string warning;   // what is said of the detector's finding; empty if nothing
  double overlap = 0.0;  // intersection over union of the mark found with the ball
};

// Learns mark number `mark` of `marks` from the ball and looks for it in the same picture.
LearningDraw learn_from(const GlossyBall& ball, const cv::Point& shift,
                        const std::vector<robot::MarkDescription>& marks, std::size_t mark, unsigned seed);

// Draws with boxes up to 5 px off along each axis, and `advance` after each.
std::vector<LearningDraw> draw_learning(const std::vector<robot::MarkDescription>& marks, std::size_t mark, int count,
                                        unsigned seed, const std::function<void()>& advance = {});

}  // namespace markservo::scenes
