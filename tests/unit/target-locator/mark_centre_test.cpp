#include "services/target-locator/centre/centre_fusion.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "services/target-locator/centre/mask_centre.hpp"
#include "services/target-locator/image/colour_projection.hpp"
#include "services/target-locator/outline/square_outline.hpp"
#include "services/target-locator/plane/disparity_plane.hpp"
#include "tests/unit/target-locator/synthetic_mark.hpp"
#include "tests/unit/target-locator/whole_mask.hpp"

namespace markservo::target_locator {
namespace {

DisparityPlane true_plane(const test::Scene& scene) {
  const auto& c = scene.camera;
  const Eigen::Vector3d n = scene.normal();
  const double unit = c.fx * c.baseline / n.dot(scene.centre);
  DisparityPlane plane;
  plane.u0 = c.cx_left;
  plane.v0 = c.cy;
  plane.at_centre = unit * n.y();
  plane.along_u = unit * n.x() / c.fx;
  plane.along_v = -unit * n.z() / c.fy;
  return plane;
}

test::Scene near_and_slanted() {
  test::Scene scene;
  scene.centre = {0.0325, 0.20, 0.0};
  scene.yaw_deg = 20.0;
  scene.noise_sigma = 0.0;
  return scene;
}

// The mask of the square without any rendering: pixels whose ray meets it.
Mask exact_mask(const test::Scene& scene, const DisparityPlane& plane) {
  const auto& c = scene.camera;
  Mask mask(640, 480);
  for (int y = 0; y < 480; ++y) {
    for (int x = 0; x < 640; ++x) {
      const double disparity = plane.at(x, y);
      const auto p = geometry::triangulate(c, {static_cast<double>(x), static_cast<double>(y), x - disparity});
      if (!p) continue;
      const Eigen::Vector3d off = *p - scene.centre;
      const double along = std::hypot(off.x(), off.y());
      mask.set(x, y, along <= 0.5 * scene.size && std::abs(off.z()) <= 0.5 * scene.size);
    }
  }
  return mask;
}

TEST(CentreOfMask, WeighsPixelsByTheAreaTheyCover) {
  const test::Scene scene = near_and_slanted();
  const DisparityPlane plane = true_plane(scene);
  const Mask mask = exact_mask(scene, plane);
  const auto truth = geometry::project(scene.camera, scene.centre);
  ASSERT_TRUE(truth);
  const auto centre = centre_of_mask(mask, {}, plane, scene.camera, CameraSide::kLeft);
  ASSERT_TRUE(centre);
  EXPECT_NEAR(centre->position.x(), truth->u_left, 0.15);
  EXPECT_NEAR(centre->position.y(), truth->v, 0.15);
  // The plain centroid is what the weights are there to correct.
  double count = 0.0;
  double sum = 0.0;
  for (int y = 0; y < 480; ++y) {
    for (int x = 0; x < 640; ++x) {
      count += mask.test(x, y);
      sum += mask.test(x, y) * x;
    }
  }
  EXPECT_GT(std::abs(sum / count - truth->u_left), 0.5);
}

TEST(AreaOnPlane, IsTheSquaresOwn) {
  const test::Scene scene = near_and_slanted();
  const DisparityPlane plane = true_plane(scene);
  const auto area = area_on_plane(exact_mask(scene, plane), {}, plane, scene.camera, CameraSide::kLeft);
  ASSERT_TRUE(area);
  EXPECT_NEAR(std::sqrt(*area), scene.size, 0.01 * scene.size);
}

TEST(PlaneNormal, PointsTowardsTheCameras) {
  test::Scene scene = near_and_slanted();
  scene.pitch_deg = 10.0;
  const Eigen::Vector3d normal = plane_normal(true_plane(scene), scene.camera);
  EXPECT_LT((normal - scene.normal()).norm(), 1e-9);
  EXPECT_LT(normal.dot(scene.centre), 0.0);
}

struct Outlined {
  std::optional<SquareOutline> outline;
  geometry::StereoPoint truth;
};

Outlined outline_of(const test::Scene& scene) {
  const auto rendered = render(scene);
  const MarkObservation observation = rendered.observation();
  MarkMasks masks;
  prepare_masks(observation.left.patch, masks);
  const Contrast contrast = mark_contrast(mark_colours(observation.left.patch, masks));
  EXPECT_TRUE(contrast.valid);
  PlaneImage image;
  project_colours(observation.left.patch, contrast.map, image);
  return {fit_square(image, masks.mask, observation.left.patch.frame, {}),
          *geometry::project(scene.camera, scene.centre)};
}

TEST(FitSquare, FindsTheCentreOfASquareTurnedAnyWay) {
  double sum = 0.0;
  int count = 0;
  for (const double roll : {0.0, 12.0, 33.0, 45.0, -20.0}) {
    test::Scene scene;
    scene.roll_deg = roll;
    scene.yaw_deg = 15.0;
    scene.pitch_deg = -10.0;
    scene.seed = static_cast<unsigned>(100.0 + roll);
    const Outlined result = outline_of(scene);
    ASSERT_TRUE(result.outline) << roll;
    const double error =
        std::hypot(result.outline->centre.x() - result.truth.u_left, result.outline->centre.y() - result.truth.v);
    EXPECT_LT(error, 0.25) << roll;
    sum += error;
    ++count;
  }
  EXPECT_LT(sum / count, 0.1);  // px
}

TEST(FitSquare, RefusesADisc) {
  PlaneImage contrast(60, 60);
  Mask mask(60, 60);
  for (int y = 0; y < 60; ++y) {
    for (int x = 0; x < 60; ++x) {
      const bool inside = std::hypot(x - 30.0, y - 29.0) < 22.0;
      mask.set(x, y, inside);
      contrast.at(x, y) = inside ? 1.0F : 0.0F;
    }
  }
  EXPECT_FALSE(fit_square(contrast, mask, {}, {}));
}

TEST(FitSquare, RefusesAnEmptyMaskAndOneWithoutMargin) {
  EXPECT_FALSE(fit_square(PlaneImage(40, 40), Mask(40, 40), {}, {}));
  EXPECT_FALSE(fit_square(PlaneImage(40, 40, 1.0F), test::whole_mask(40, 40), {}, {}));
}

TEST(FuseCentres, GrowsItsCovarianceWhenTheViewsContradictEachOther) {
  const geometry::StereoCamera camera = test::default_camera();
  PlaneAlignment alignment;
  alignment.plane = {400.0, 240.0, 200.0, 0.0, 0.0};
  alignment.covariance.diagonal() << 4e-4, 1e-8, 1e-8;
  const Eigen::Matrix2d sharp = Eigen::Matrix2d::Identity() * 0.0025;
  const ImageCentre left{{400.0, 240.0}, sharp};
  const auto agreed = fuse_centres(left, ImageCentre{{200.0, 240.0}, sharp}, alignment, camera);
  const auto torn = fuse_centres(left, ImageCentre{{203.0, 240.0}, sharp}, alignment, camera);
  const auto alone = fuse_centres(left, std::nullopt, alignment, camera);
  ASSERT_TRUE(agreed && torn && alone);
  EXPECT_NEAR(agreed->p_C.y(), camera.fx * camera.baseline / 200.0, 1e-9);
  EXPECT_GT(torn->covariance.trace(), 50.0 * agreed->covariance.trace());
  EXPECT_GT(alone->covariance(0, 0), agreed->covariance(0, 0));
  EXPECT_FALSE(fuse_centres(std::nullopt, std::nullopt, alignment, camera));
}

}  // namespace
}  // namespace markservo::target_locator
