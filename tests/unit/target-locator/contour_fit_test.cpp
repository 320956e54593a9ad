// Contours fitted to drawn coverage: the whole of what the image is made of is known.

#include "services/target-locator/contour/contour_fit.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <random>

#include "services/target-locator/contour/chance.hpp"
#include "services/target-locator/contour/ellipse_contour.hpp"
#include "services/target-locator/contour/quad_contour.hpp"
#include "services/target-locator/image/texture_strength.hpp"
#include "tests/scenes/area_coverage.hpp"

namespace markservo::target_locator {
namespace {

constexpr int kEdge_px = 96;  // of the image
constexpr double kBlur_px = 0.7;

using Levels = std::function<double(double x, double y, double share)>;

double even(double /*x*/, double /*y*/, double share) {
  return share;
}

PlaneImage image_of(const std::vector<cv::Point2d>& polygon, const Levels& level, double sigma, unsigned seed) {
  const cv::Mat1f coverage = scenes::blurred_coverage(polygon, {0, 0, kEdge_px, kEdge_px}, kBlur_px);
  std::mt19937 random(seed);
  std::normal_distribution<double> noise(0.0, 1.0);
  PlaneImage image(kEdge_px, kEdge_px);
  for (int y = 0; y < kEdge_px; ++y) {
    for (int x = 0; x < kEdge_px; ++x) {
      image.at(x, y) = static_cast<float>(level(x, y, static_cast<double>(coverage(y, x))) + sigma * noise(random));
    }
  }
  return image;
}

// Turned by 12 degrees, its middle between pixels.
std::vector<cv::Point2d> square(double half = 28.0) {
  std::vector<cv::Point2d> corners;
  const double turn = 12.0 * M_PI / 180.0;
  for (int k = 0; k < 4; ++k) {
    const double angle = turn + (2 * k + 1) * M_PI / 4.0;
    corners.push_back({47.3 + std::sqrt(2.0) * half * std::cos(angle), 48.6 + std::sqrt(2.0) * half * std::sin(angle)});
  }
  return corners;
}

// The sides of the polygon moved outwards by `off` px: where a fit may begin.
QuadContour around(const std::vector<cv::Point2d>& corners, double off) {
  Lines lines;
  for (std::size_t k = 0; k < 4; ++k) {
    const Eigen::Vector2d a(corners[k].x, corners[k].y);
    const Eigen::Vector2d b(corners[(k + 1) % 4].x, corners[(k + 1) % 4].y);
    const Eigen::Vector2d normal = Eigen::Vector2d(b.y() - a.y(), a.x() - b.x()).normalized();
    lines[k] = {normal, normal.dot(a) + off};
  }
  return QuadContour::from_lines(lines).value();
}

// Between the corners found and the polygon's, the largest; corner k of the fit is the polygon's corner k + 1.
double corners_off(const QuadContour& contour, const std::vector<cv::Point2d>& corners) {
  const Corners found = contour.corners().value();
  double most = 0.0;
  for (std::size_t k = 0; k < 4; ++k) {
    const cv::Point2d& expected = corners[(k + 1) % 4];
    most = std::max(most, (found[k] - Eigen::Vector2d(expected.x, expected.y)).norm());
  }
  return most;
}

TEST(ContourFit, FindsASquaresCornersToAHundredthOfAPixel) {
  const auto fitted = fit_contour(image_of(square(), even, 0.0, 1), around(square(), 0.8), {});
  ASSERT_TRUE(fitted);
  EXPECT_LT(corners_off(fitted->shape, square()), 0.01);
  EXPECT_NEAR(fitted->blur, kBlur_px, 0.02);
}

TEST(ContourFit, FindsItWhereLightFallsFromOneSideAndTheGroundChanges) {
  const Levels lit = [](double x, double y, double share) {
    return share * (1.0 + 0.004 * (x - 48.0)) + (1.0 - share) * (0.003 * (y - 48.0));
  };
  const auto fitted = fit_contour(image_of(square(), lit, 0.0, 1), around(square(), 0.5), {});
  ASSERT_TRUE(fitted);
  EXPECT_LT(corners_off(fitted->shape, square()), 0.05);
}

TEST(ContourFit, FindsItWhereAShadowCrossesIt) {
  const Levels shaded = [](double x, double y, double share) { return share * (x + 0.5 * y > 70.0 ? 0.6 : 1.0); };
  const auto fitted = fit_contour(image_of(square(), shaded, 0.01, 1), around(square(), 0.5), {});
  ASSERT_TRUE(fitted);
  EXPECT_LT(corners_off(fitted->shape, square()), 0.1);
}

TEST(ContourFit, LeavesOutWhatHidesALittleOfASide) {
  // Something of the mark's colour sticks out over a seventh of the right side.
  const Levels touched = [](double x, double y, double share) {
    return x > 70.0 && y > 44.0 && y < 52.0 ? 1.0 : share;
  };
  const auto fitted = fit_contour(image_of(square(), touched, 0.01, 1), around(square(), 0.5), {});
  ASSERT_TRUE(fitted);
  EXPECT_LT(corners_off(fitted->shape, square()), 0.05);
}

TEST(ContourFit, RefusesASideOfWhichMostIsHidden) {
  const Levels touched = [](double x, double y, double share) {
    return x > 60.0 && y > 25.0 && y < 68.0 ? 1.0 : share;
  };
  EXPECT_FALSE(fit_contour(image_of(square(), touched, 0.01, 1), around(square(), 0.5), {}));
}

TEST(ContourFit, RefusesWhatHasNoOutline) {
  const Levels nothing = [](double, double, double) { return 0.5; };
  EXPECT_FALSE(fit_contour(image_of(square(), nothing, 0.03, 1), around(square(), 0.0), {}));
}

// Mean of the squared error over the stated covariance: 8 for 8 parameters, of 60 draws within a half or so.
TEST(ContourFit, SaysHowWellItKnowsTheSides) {
  double sum = 0.0;
  constexpr int kDraws = 60;
  for (unsigned seed = 1; seed <= kDraws; ++seed) {
    const QuadContour truth = around(square(), 0.0);
    const auto fitted = fit_contour(image_of(square(), even, 0.04, seed), truth, {});
    ASSERT_TRUE(fitted) << seed;
    // The fit began at the truth, so that its parameters are its errors.
    const QuadContour::Vector& error = fitted->shape.parameters();
    sum += error.dot(fitted->covariance.inverse() * error);
  }
  EXPECT_GT(sum / kDraws, 6.0);
  EXPECT_LT(sum / kDraws, 10.0);
}

// The same where the noise is that of blocks of pixels, as packing leaves it.
TEST(ContourFit, SaysHowWellItKnowsTheSidesWherePixelsErrTogether) {
  double sum = 0.0;
  constexpr int kDraws = 60;
  constexpr std::size_t kBlock_px = 6;
  for (unsigned seed = 1; seed <= kDraws; ++seed) {
    std::mt19937 random(seed);
    std::normal_distribution<double> normal(0.0, 0.04);
    constexpr std::size_t kBlocks = kEdge_px / kBlock_px;
    std::array<double, kBlocks * kBlocks> noise;
    for (double& of_block : noise) of_block = normal(random);
    const Levels packed = [&](double x, double y, double share) {
      const std::size_t row = static_cast<std::size_t>(y) / kBlock_px;
      return share + noise[row * kBlocks + static_cast<std::size_t>(x) / kBlock_px];
    };
    const auto fitted = fit_contour(image_of(square(), packed, 0.01, seed), around(square(), 0.0), {});
    ASSERT_TRUE(fitted) << seed;
    EXPECT_GT(fitted->roughness, 1.0);
    const QuadContour::Vector& error = fitted->shape.parameters();
    sum += error.dot(fitted->covariance.inverse() * error);
  }
  EXPECT_GT(sum / kDraws, 4.0);
  EXPECT_LT(sum / kDraws, 12.0);
}

TEST(ExplainedByChance, IsTheChiSquareThatNinetyNineOfAHundredDrawsStayBelow) {
  EXPECT_NEAR(2.0 * explained_by_chance(2.0), 9.210, 0.03);
  EXPECT_NEAR(5.0 * explained_by_chance(5.0), 15.086, 0.05);
  EXPECT_NEAR(100.0 * explained_by_chance(100.0), 135.807, 0.1);
}

TEST(ContourFit, FindsAnEllipseToAHundredthOfAPixel) {
  std::vector<cv::Point2d> polygon;
  Eigen::Matrix2d root;
  root << 26.0, 3.0, 0.0, 22.0;
  for (int k = 0; k < 720; ++k) {
    const double angle = k * M_PI / 360.0;
    const Eigen::Vector2d p = root * Eigen::Vector2d(std::cos(angle), std::sin(angle));
    polygon.push_back({47.4 + p.x(), 46.9 + p.y()});
  }
  const Eigen::Matrix2d shape = root * root.transpose();
  const EllipseContour start({47.9, 46.5}, 1.04 * shape);
  const auto fitted = fit_contour(image_of(polygon, even, 0.0, 1), start, {});
  ASSERT_TRUE(fitted);
  const EllipseContour::Vector& found = fitted->shape.parameters();
  EXPECT_NEAR(found[0], 47.4, 0.01);
  EXPECT_NEAR(found[1], 46.9, 0.01);
  // A blur of b px makes a radius of r px smaller by b^2 / (2 r).
  EXPECT_NEAR(std::sqrt(found[2]), std::sqrt(shape(0, 0)), 0.03);
  EXPECT_NEAR(std::sqrt(found[4]), std::sqrt(shape(1, 1)), 0.03);
}

Mask all_set() {
  Mask mask;
  mask.reset(kEdge_px, kEdge_px);
  for (int y = 0; y < kEdge_px; ++y) {
    for (int x = 0; x < kEdge_px; ++x) mask.set(x, y, true);
  }
  return mask;
}

TEST(TextureStrength, IsThatOfThePrintAndNotOfNoiseOrLight) {
  const auto strength = [](const Levels& level, double sigma) {
    return texture_strength(image_of(square(), level, sigma, 3), all_set());
  };
  const Levels light = [](double x, double y, double) { return 100.0 + 0.5 * x + 0.2 * y; };
  EXPECT_LT(strength(light, 3.0), 0.6);
  const Levels print = [](double x, double y, double) { return 100.0 + 10.0 * std::sin(0.5 * x) * std::sin(0.4 * y); };
  EXPECT_NEAR(strength(print, 3.0), 5.0 * std::sqrt(std::cos(0.5)), 0.5);
}

}  // namespace
}  // namespace markservo::target_locator
