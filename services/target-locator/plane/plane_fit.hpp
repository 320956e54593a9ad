#pragma once

// Gauss-Newton for the plane of disparities, over one set of pixels.
//
// The model is right(u - disparity) = gain left + offset + rising d left / dv, and its six parameters are: disparity at
// the template's origin, along u, along v (both per extent of the template), gain, offset, and how much higher the
// right view lies than the rows say. A variant of Lucas and Kanade's (refinement.hpp) that fits all of a mark at once.

#include <Eigen/Core>
#include <Eigen/LU>
#include <optional>
#include <vector>

#include "services/target-locator/image/stereo_patch.hpp"
#include "services/target-locator/plane/disparity_plane.hpp"
#include "services/target-locator/plane/plane_kernel.hpp"
#include "services/target-locator/plane/plane_template.hpp"

namespace markservo::target_locator {

using Vector6 = Eigen::Matrix<double, kPlaneParameters, 1>;
using Matrix6 = Eigen::Matrix<double, kPlaneParameters, kPlaneParameters>;

// The parameters of the plane without any change of light or rows.
Vector6 parameters_of(const DisparityPlane& plane, const PlaneTemplate& t);
DisparityPlane plane_of(const Vector6& parameters, const PlaneTemplate& t);

// When an iteration ends.
struct FitLimits {
  int iterations = 1;
  double settled_px = 0.0;     // a step that moves the disparities by less is the last
  double max_change_px = 0.0;  // from the start; beyond three times that, in sum, it ran away
};

class PlaneFit {
 public:
  // Works on `pixels`, one of the two of `templates`; refers to them and to the patch.
  PlaneFit(const StereoPatch& patch, PlaneTemplates& templates, PlaneTemplate& pixels);

  const PlaneTemplate& pixels() const { return pixels_; }
  const Vector6& parameters() const { return parameters_; }
  // Whether enough pixels are left.
  bool solvable() const { return solvable_; }

  // Iterates from `start` on; residuals are those before the last step. False when it diverges.
  bool iterate(const Vector6& start, const FitLimits& limits);

  // Leaves out the pixels with large residuals; returns the share that stays.
  double drop_outliers(double sigmas);

  // Correlation of the two views' greys, -1..1.
  double correlation() const;

  // Covariance of the parameters; nothing when the texture does not fix them.
  std::optional<Matrix6> covariance(double noise_correlation) const;

 private:
  struct NormalMatrices {
    Matrix6 newton = Matrix6::Zero();       // derivative of the normal equations
    Matrix6 information = Matrix6::Zero();  // of their noise, times the residuals' variance
    double count = 0.0;
  };

  static NormalMatrices normal_matrices(const PlaneTemplate& t);
  void factorise();
  void evaluate();

  const StereoPatch& patch_;
  PlaneTemplate& pixels_;
  NormalMatrices normal_;
  Eigen::PartialPivLU<Matrix6> solver_;
  bool solvable_ = false;
  Vector6 parameters_ = Vector6::Zero();
  std::vector<float>& warped_;
  std::vector<float>& residual_;
  Vector6 right_side_ = Vector6::Zero();
  double sum_of_squares_ = 0.0;
};

}  // namespace markservo::target_locator
