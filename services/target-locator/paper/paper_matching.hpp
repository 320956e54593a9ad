#pragma once

// The paper's matching as it stands, kept as the baseline to compare with.

#include <Eigen/Core>
#include <vector>

#include "common/geometry/stereo_camera.hpp"
#include "services/target-locator/features/features.hpp"
#include "services/target-locator/image/gradients.hpp"
#include "services/target-locator/location.hpp"
#include "services/target-locator/mark_observation.hpp"

namespace markservo::target_locator {

struct PaperParameters {
  double alpha = 1.0;     // of eq. 4; scales S and changes no minimum
  double window = 0.5;    // `a` of eq. 3: side of the search window over side of the mark's box
  int outline_reach = 3;  // patch px beyond the mask: corners of the outline of a mark that has no others
  int min_corners = 3;    // of an outline, that carry a position
};

// The right point of every feature: the pixel of a window, `window` times the mark's box (paper eq. 3) around where the
// feature would be if the two boxes fitted, whose gradient differs least from the feature's (paper eq. 4, taking the
// smallest difference). Whole patch pixels; residual is |g_L - g_R| in grey levels per px.
std::vector<Match> match_as_in_the_paper(const std::vector<Feature>& features, const Gradients& left,
                                         const Gradients& right, const View& left_view, const View& right_view,
                                         const PaperParameters& parameters);

struct PaperPosition {
  Eigen::Vector3d p_C = Eigen::Vector3d::Zero();         // m, mean of the triangulated matches (paper eq. 5)
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();  // m^2, of that mean, from the points' scatter
  int num_points = 0;                                    // with a positive disparity
};
PaperPosition position_as_in_the_paper(const std::vector<Match>& matches, const geometry::StereoCamera& camera);

}  // namespace markservo::target_locator
