#include "common/geometry/stereo_camera.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

namespace markservo::geometry {
namespace {

const StereoCamera kCamera{784.0, 784.0, 319.5, 319.5, 239.5, 0.065};

TEST(StereoCamera, DisparityFollowsDepth) {
  // 50,960 / Z px with Z in mm: the paper's cameras.
  const auto near = project(kCamera, {0.0, 0.150, 0.0});
  const auto far = project(kCamera, {0.0, 0.350, 0.0});
  EXPECT_NEAR(kCamera.disparity(*near), 339.7, 0.1);
  EXPECT_NEAR(kCamera.disparity(*far), 145.6, 0.1);
}

TEST(StereoCamera, RightIsRightAndUpIsUpInTheImage) {
  const auto point = project(kCamera, {0.01, 0.25, 0.01});
  EXPECT_GT(point->u_left, kCamera.cx_left);
  EXPECT_LT(point->v, kCamera.cy);
  EXPECT_LT(point->u_right, point->u_left);
}

TEST(StereoCamera, TriangulatesWhatItProjects) {
  for (const Eigen::Vector3d& p_C : {Eigen::Vector3d(0.03, 0.25, 0.03), Eigen::Vector3d(-0.1, 0.35, -0.05)}) {
    EXPECT_TRUE(triangulate(kCamera, *project(kCamera, p_C))->isApprox(p_C, 1e-12));
  }
}

TEST(StereoCamera, SeesNothingBehindTheLensesOrAtNegativeDisparity) {
  EXPECT_FALSE(project(kCamera, {0.0, 0.0, 0.0}));
  EXPECT_FALSE(project(kCamera, {0.0, -0.2, 0.0}));
  EXPECT_FALSE(triangulate(kCamera, {300.0, 200.0, 300.0}));
  EXPECT_THROW(triangulation_jacobian(kCamera, {300.0, 200.0, 310.0}), std::invalid_argument);
}

TEST(StereoCamera, JacobianAgreesWithDifferences) {
  const StereoPoint point{400.0, 180.0, 200.0};
  const Eigen::Matrix3d jacobian = triangulation_jacobian(kCamera, point);
  constexpr double kStep = 1e-4;  // px
  for (int axis = 0; axis < 3; ++axis) {
    const auto moved = [&](double step) {
      StereoPoint p = point;
      if (axis == 0) {
        p.u_left += step;
        p.u_right += step;
      } else if (axis == 1) {
        p.v += step;
      } else {
        p.u_right -= step;
      }
      return *triangulate(kCamera, p);
    };
    const Eigen::Vector3d numeric = (moved(kStep) - moved(-kStep)) / (2.0 * kStep);
    EXPECT_TRUE(jacobian.col(axis).isApprox(numeric, 1e-6)) << "axis " << axis;
  }
}

}  // namespace
}  // namespace markservo::geometry
