#pragma once

// A mark before a cluttered wall, perhaps partly behind something, seen by the robot's cameras with noise; and the real
// detector and locator looking at it.

#include <optional>
#include <vector>

#include "common/robot/robot_description.hpp"
#include "services/mark-detector/mark_detector.hpp"
#include "services/target-locator/mark_locator.hpp"
#include "tests/scenes/printed_surface.hpp"

namespace markservo::scenes {

struct StageParameters {
  int num_samples = 8;   // a pixel, along each axis
  double blur_px = 0.6;  // sigma of the lens
  double sigma = 3.0;    // grey levels of noise in each channel
  unsigned seed = 1;     // of the wall
};

// One camera's picture.
struct StagedView {
  cv::Mat frame;                   // 8-bit BGR, of the camera's size
  cv::Rect drawn;                  // px: the part about the mark
  cv::Mat3f clean;                 // that part without noise
  cv::Mat3f clean_change_along_u;  // of `clean`, grey levels per px
};

struct StagedPair {
  StagedView left;
  StagedView right;
};

class MarkStage {
 public:
  // Renders the wall.
  MarkStage(const robot::RobotDescription& robot, const StageParameters& parameters);

  // `surfaces` from far to near before the wall; drawn as far as they lie about `mark`.
  StagedPair render(const std::vector<Surface>& surfaces, const Surface& mark, cv::RNG& random) const;

 private:
  StagedView render_view(const std::vector<Surface>& surfaces, const Surface& mark, bool right, cv::RNG& random) const;

  robot::CameraDescription cameras_;
  StageParameters parameters_;
  std::vector<Surface> background_;
  cv::Mat left_wall_;
  cv::Mat right_wall_;
};

// The surface of a mark at `centre` with the robot's print, turned about the vertical, the horizontal and its own axis.
Surface mark_surface(const robot::MarkDescription& mark, const Eigen::Vector3d& centre, const Eigen::Vector3d& turn_deg,
                     unsigned seed);

}  // namespace markservo::scenes
