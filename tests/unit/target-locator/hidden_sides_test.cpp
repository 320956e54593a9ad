#include "services/target-locator/hidden/hidden_sides.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <functional>

#include "services/target-locator/plane/shared_visibility.hpp"

namespace markservo::target_locator {
namespace {

const geometry::StereoCamera kCamera{784.0, 784.0, 319.5, 319.5, 239.5, 0.065};
constexpr double kSize = 0.025;  // m

// A square that faces the cameras 250 mm away, turned in its plane.
struct Square {
  Eigen::Vector3d centre = {0.031, 0.25, 0.004};
  double turn_deg = 4.0;

  DisparityPlane plane() const {
    const auto seen = *geometry::project(kCamera, centre);
    return {seen.u_left, seen.v, seen.u_left - seen.u_right, 0.0, 0.0};
  }
};

// What is hidden from a camera, by the sight line's place on the square's plane (m from its centre).
using Hidden = std::function<bool(double x, double z, bool right)>;

struct Masks {
  Mask left;
  Mask right;
  PatchFrame left_frame;
  PatchFrame right_frame;
};

Masks draw(const Square& square, const Hidden& hidden) {
  constexpr int kEdge = 120;  // px
  const auto seen = *geometry::project(kCamera, square.centre);
  const auto frame = [](double u, double v) {
    return PatchFrame{std::round(u) - kEdge / 2, std::round(v) - kEdge / 2, 1.0};
  };
  Masks masks{Mask(kEdge, kEdge), Mask(kEdge, kEdge), frame(seen.u_left, seen.v), frame(seen.u_right, seen.v)};
  const double turn = square.turn_deg * M_PI / 180.0;
  for (const bool right : {false, true}) {
    const PatchFrame& patch = right ? masks.right_frame : masks.left_frame;
    for (int y = 0; y < kEdge; ++y) {
      for (int x = 0; x < kEdge; ++x) {
        const double dx = (patch.u_of(x) - (right ? seen.u_right : seen.u_left)) * square.centre.y() / kCamera.fx;
        const double dz = -(patch.v_of(y) - seen.v) * square.centre.y() / kCamera.fy;
        const double a = std::cos(turn) * dx + std::sin(turn) * dz;
        const double b = -std::sin(turn) * dx + std::cos(turn) * dz;
        const bool on_square = std::max(std::abs(a), std::abs(b)) <= 0.5 * kSize;
        (right ? masks.right : masks.left).set(x, y, on_square && !hidden(dx, dz, right));
      }
    }
  }
  return masks;
}

struct Placed {
  std::optional<ImageCentre> centre;
  Eigen::Vector2d error = Eigen::Vector2d::Zero();  // px
};

Placed place(const Square& square, const Hidden& hidden, double size = kSize) {
  const Masks masks = draw(square, hidden);
  const DisparityPlane plane = square.plane();
  Placed placed;
  placed.centre = centre_of_hidden_square({masks.left, masks.left_frame}, {masks.right, masks.right_frame}, plane, 0.0,
                                          kCamera, size, {});
  if (placed.centre) placed.error = placed.centre->position - Eigen::Vector2d(plane.u0, plane.v0);
  return placed;
}

constexpr double kParallax = 0.008;  // m on the square's plane between what both cameras see of a thing 27 mm nearer
constexpr double kPixel = 0.25 / 784.0;  // m

TEST(HiddenSquare, IsPlacedExactlyWhenNothingHidesIt) {
  const Placed placed = place({}, [](double, double, bool) { return false; });
  ASSERT_TRUE(placed.centre);
  EXPECT_LT(placed.error.norm(), 0.15);
  EXPECT_LT(std::sqrt(placed.centre->covariance.trace()), 0.3);
}

TEST(HiddenSquare, IsPlacedByTheSidesThatAreSeenWhereverItIsHiddenFrom) {
  for (const double from_deg : {0.0, 35.0, 70.0, 110.0, 145.0, 180.0, 215.0, 250.0, 290.0, 325.0}) {
    const Eigen::Vector2d from(std::cos(from_deg * M_PI / 180.0), std::sin(from_deg * M_PI / 180.0));
    const Placed placed = place({}, [&](double x, double z, bool right) {
      return from.dot(Eigen::Vector2d(x + (right ? kParallax : 0.0), z)) > 0.004;
    });
    ASSERT_TRUE(placed.centre) << from_deg;
    EXPECT_LT(placed.error.norm(), 0.6) << from_deg;
    const double distance = placed.error.dot(placed.centre->covariance.inverse() * placed.error);
    EXPECT_LT(distance, 11.8) << from_deg;
    EXPECT_LT(std::sqrt(placed.centre->covariance.trace()), 1.0) << from_deg;
  }
}

// An edge along the rows, parallel to the square: both cameras see it at the same place, as they would a side.
TEST(HiddenSquare, LiesAnywhereBetweenWhenItsSidesCannotBeToldFromWhatHides) {
  Square square;
  square.turn_deg = 0.0;
  const double hidden = 0.010;  // m
  const Placed placed = place(square, [&](double, double z, bool) { return z > 0.5 * kSize - hidden; });
  ASSERT_TRUE(placed.centre);
  const double sigma_v = std::sqrt(placed.centre->covariance(1, 1)) * kPixel;
  EXPECT_LT(std::sqrt(placed.centre->covariance(0, 0)) * kPixel, 0.2e-3);
  EXPECT_GT(sigma_v, 0.35 * hidden);
  EXPECT_LT(sigma_v, 0.6 * hidden);
  EXPECT_LT(std::abs(placed.error.y()) * kPixel, 1.5 * sigma_v);
}

TEST(HiddenSquare, IsRefusedWhenTheMasksShowMoreThanItHolds) {
  EXPECT_FALSE(place(
                   {}, [](double, double, bool) { return false; }, 0.8 * kSize)
                   .centre);
}

TEST(HiddenSquare, IsRefusedWhenNextToNothingIsSeen) {
  EXPECT_FALSE(place({}, [](double x, double z, bool) { return std::hypot(x, z) > 0.002; }).centre);
}

TEST(SeenByBoth, LeavesOutWhatEitherCameraDoesNotSee) {
  const Square square;
  const Masks masks = draw(square, [](double x, double, bool right) { return right ? x > 0.004 : x < -0.006; });
  Mask both;
  seen_by_both(masks.left, masks.left_frame, masks.right, masks.right_frame, square.plane(), both);
  const auto seen = *geometry::project(kCamera, square.centre);
  int count = 0;
  for (int y = 0; y < both.height(); ++y) {
    for (int x = 0; x < both.width(); ++x) {
      if (!both.test(x, y)) continue;
      ++count;
      const double place_x = (masks.left_frame.u_of(x) - seen.u_left) * kPixel;
      EXPECT_GT(place_x, -0.006 - kPixel);
      EXPECT_LT(place_x, 0.004 + kPixel);
    }
  }
  EXPECT_NEAR(count * kPixel * kPixel, 0.010 * kSize, 0.05 * 0.010 * kSize);
}

}  // namespace
}  // namespace markservo::target_locator
