#pragma once

// A printed square mark before a wall, seen by two cameras: every image pixel on an outline is the mean of 32 x 32
// rays, the others of 4 x 4, so that no interpolation of ours takes part in making the pictures.

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "common/geometry/stereo_camera.hpp"
#include "services/target-locator/mark_observation.hpp"

namespace markservo::target_locator::test {

// The default robot's cameras.
geometry::StereoCamera default_camera();

struct Scene {
  geometry::StereoCamera camera = default_camera();
  Eigen::Vector3d centre = {0.03, 0.25, 0.0};  // m, of the mark, in C
  double size = 0.025;                         // m
  double yaw_deg = 0.0;                        // slant about the vertical
  double pitch_deg = 0.0;                      // slant about the horizontal
  double roll_deg = 0.0;                       // turn in its own plane
  double texture_depth = 0.55;                 // share of the brightness that the print varies by; 0: uniform
  double wall_gap = 0.03;                      // m, the background lies this far behind the mark's centre
  double noise_sigma = 3.0;                    // grey levels
  double right_gain = 1.0;                     // of the right camera
  double right_row_shift = 0.0;                // px, what the right image is lowered by: a badly rectified pair
  unsigned seed = 1;                           // of texture and noise
  double hidden_share = 0.0;                   // of the mark's width, covered from its left edge by a grey bar in front
  bool other_texture_in_right = false;         // another mark of the same colour

  Eigen::Vector3d normal() const;  // towards the cameras
};

// A view that owns its bytes.
struct RenderedView {
  View view;
  std::vector<std::uint8_t> bgr;
  std::vector<std::uint8_t> mask;
};

struct RenderedMark {
  RenderedView left;
  RenderedView right;
  MarkObservation observation(Surface surface = Surface::kPlane, double size = 0.025) const;
};

// Renders the mark's surroundings, adds noise, finds the mask by its colour and cuts patches of at most `patch_limit`
// pixels along each axis with a margin of 8 image pixels about the mark's box.
RenderedMark render(const Scene& scene, int patch_limit = 128);

}  // namespace markservo::target_locator::test
