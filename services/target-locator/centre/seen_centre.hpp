#pragma once

// Where one image shows the centre of a flat mark: by its outline if that is seen whole, else by its mask.

#include <optional>

#include "common/geometry/stereo_camera.hpp"
#include "services/target-locator/image/colour_projection.hpp"
#include "services/target-locator/image/image_centre.hpp"
#include "services/target-locator/mark_observation.hpp"
#include "services/target-locator/outline/square_outline.hpp"
#include "services/target-locator/plane/disparity_plane.hpp"

namespace markservo::target_locator {

struct SeenCentreParameters {
  OutlineParameters outline;
  double size_tolerance = 0.04;  // relative, of the square's sides before it counts as not seen whole
  double unknown_missing = 0.1;  // relative: what may be missing of a mask where the size is not known
  // What the print at an outline adds to the centre's covariance, as a factor. Two views show the same print, so that
  // their errors are alike and do not average out as errors that count as independent do.
  double print_doubt = 2.0;
};

struct SeenCentre {
  ImageCentre centre;
  bool outlined = false;  // seen whole
};

// What is known of the mark in one image.
struct CentreView {
  const View& view;
  const Mask& mask;
  const MarkColours& colours;
  CameraSide side;
};

// The mark's centre in one image, with what is missing of the mark in the covariance. `size`: m, edge of the square; 0:
// unknown. Nothing when the mark is not in front of the cameras or nothing of it is seen. `contrast` is room.
std::optional<SeenCentre> seen_centre(const CentreView& seen, const DisparityPlane& plane,
                                      const geometry::StereoCamera& camera, double size,
                                      const SeenCentreParameters& parameters, PlaneImage& contrast);

// Corners of an outline in the left image, on the plane in space: lengths of its four sides, m. Nothing when a corner
// is not in front of the cameras.
std::optional<Eigen::Vector4d> side_lengths(const SquareOutline& outline, const DisparityPlane& plane,
                                            const geometry::StereoCamera& camera);

}  // namespace markservo::target_locator
