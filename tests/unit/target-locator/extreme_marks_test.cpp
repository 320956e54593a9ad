// Views of marks that no detector should send: without texture, tiny, huge, with masks like sieves, boxes and cameras
// beyond all measure. A position that holds or a status, no crash, bounded memory.

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "services/target-locator/mark_locator.hpp"
#include "tests/unit/allocation_count.hpp"
#include "tests/unit/target-locator/synthetic_mark.hpp"

namespace markservo::target_locator {
namespace {

using Levels = std::function<int(int column, int row)>;
using Inside = std::function<bool(int column, int row)>;

// A view whose patch is `width` x `height` px at (x, 200) of the image, the mark 8 px from its borders.
struct Sketch {
  View view;
  std::vector<std::uint8_t> bgr;
  std::vector<std::uint8_t> mask;

  Sketch(int width, int height, double x, const Levels& level, const Inside& inside) {
    view.seen = true;
    view.patch.width = width;
    view.patch.height = height;
    view.patch.frame = {x, 200.0, 1.0};
    view.x = x + 8.0;
    view.y = 208.0;
    view.width = std::max(1, width - 16);
    view.height = std::max(1, height - 16);
    const std::size_t stride = (static_cast<std::size_t>(width) + 7) / 8;
    mask.resize(stride * static_cast<std::size_t>(height));
    for (int row = 0; row < height; ++row) {
      for (int column = 0; column < width; ++column) {
        const auto grey = static_cast<std::uint8_t>(level(column, row));
        bgr.insert(bgr.end(), {grey, grey, static_cast<std::uint8_t>(grey / 2 + 100)});
        if (!inside(column, row)) continue;
        std::uint8_t& byte = mask[static_cast<std::size_t>(row) * stride + static_cast<std::size_t>(column) / 8];
        byte = static_cast<std::uint8_t>(byte | (1U << (column % 8)));
      }
    }
    view.patch.bgr = bgr.data();
    view.patch.mask = mask.data();
  }
  Sketch(const Sketch&) = delete;
  Sketch& operator=(const Sketch&) = delete;
};

int noise(int column, int row) {
  // A hash, mixed twice: neighbours have nothing in common.
  auto bits = static_cast<unsigned>(4096 * row + column) * 2654435761U;
  bits = (bits ^ (bits >> 15U)) * 2246822519U;
  return static_cast<int>((bits >> 16U) % 256U);
}

bool everywhere(int /*column*/, int /*row*/) {
  return true;
}

void expect_sane(const Location& location) {
  EXPECT_LE(location.matches.size(), static_cast<std::size_t>(FeatureParameters{}.max_features));
  if (location.status != Status::kLocated) {
    EXPECT_TRUE(location.p_C.isZero(0.0));
    EXPECT_TRUE(location.covariance.isZero(0.0));
    return;
  }
  ASSERT_TRUE(location.p_C.allFinite());
  ASSERT_TRUE(location.covariance.allFinite());
  EXPECT_GT(location.p_C.y(), 0.0);
  const double largest = location.covariance.cwiseAbs().maxCoeff();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(location.covariance / largest);
  EXPECT_GE(solver.eigenvalues().minCoeff(), -1e-9);
}

// By both methods and as both surfaces; the answers of our own method for a plane come first.
std::vector<Location> locate_every_way(MarkObservation observation, const geometry::StereoCamera& camera) {
  std::vector<Location> locations;
  for (const Method method : {Method::kRefined, Method::kPaper}) {
    for (const Surface surface : {Surface::kPlane, Surface::kFree, Surface::kBall}) {
      LocatorParameters parameters;
      parameters.method = method;
      observation.surface = surface;
      locations.push_back(locate_mark(observation, camera, parameters));
      expect_sane(locations.back());
    }
  }
  return locations;
}

std::vector<Location> locate_sketch(int width, int height, const Levels& level, const Inside& inside = everywhere) {
  const Sketch left(width, height, 400.0, level, inside);
  const Sketch right(width, height, 200.0, level, inside);
  MarkObservation observation;
  observation.left = left.view;
  observation.right = right.view;
  observation.size = 0.025;
  return locate_every_way(observation, test::default_camera());
}

TEST(ExtremeMark, WithoutTextureIsNotLocated) {
  for (const int level : {0, 120, 255}) {
    for (const Location& location : locate_sketch(64, 64, [level](int, int) { return level; })) {
      EXPECT_EQ(location.status, Status::kTooFewMatches);
    }
  }
}

TEST(ExtremeMark, WithTextureAlongOneAxisOnlyIsNotLocatedAsAPlane) {
  const auto rows = locate_sketch(64, 64, [](int, int row) { return noise(0, row); });
  EXPECT_NE(rows[0].status, Status::kLocated);
}

TEST(ExtremeMark, OfAnySizeGivesAnAnswer) {
  for (const int side : {1, 2, 7, 8, 9, 15, 16, 17, 31, 33, 63, 64, 65, 127, 128, 129}) {
    for (const auto& [width, height] : {std::pair{side, side}, std::pair{side, 40}, std::pair{40, side}}) {
      SCOPED_TRACE(std::to_string(width) + " x " + std::to_string(height));
      const auto locations = locate_sketch(width, height, noise);
      const bool too_small = std::min(width, height) < 8;
      EXPECT_TRUE(!too_small || locations[0].status == Status::kTooFewMatches);
    }
  }
  locate_sketch(4096, 8, noise);
  locate_sketch(8, 4096, noise);
}

TEST(ExtremeMark, WhoseMaskIsASieveOrEmptyGivesAnAnswer) {
  const Inside masks[] = {
      [](int, int) { return false; },
      [](int column, int row) { return (column + row) % 2 == 0; },
      [](int column, int row) { return noise(column, row + 1000) % 2 == 0; },
      [](int column, int row) { return column == 20 && row == 20; },
      [](int column, int) { return column == 20; },
      [](int, int row) { return row == 20; },
      [](int column, int row) { return column == 0 || row == 0 || column == 63 || row == 63; },
  };
  for (const Inside& inside : masks) locate_sketch(64, 64, noise, inside);
}

TEST(ExtremeMark, OfLargePatchesTakesMemoryInProportionToThem) {
  constexpr int kSide = 1024;
  const Sketch left(kSide, kSide, 2000.0, noise, everywhere);
  const Sketch right(kSide, kSide, 1000.0, noise, everywhere);
  MarkObservation observation;
  observation.left = left.view;
  observation.right = right.view;
  observation.surface = Surface::kPlane;
  const std::size_t peak = markservo::test::peak_bytes(
      [&] { expect_sane(locate_mark(observation, test::default_camera(), LocatorParameters())); });
  RecordProperty("bytes_per_pixel", std::to_string(static_cast<double>(peak) / (kSide * kSide)));
  EXPECT_LT(peak, std::size_t{64} * kSide * kSide) << "floats for two views, gradients, corner measures and masks";
}

// How far the search for a start may reach is the boxes' word, and a message can say anything.
TEST(ExtremeMark, WithBoxesBeyondAllMeasureEndsAsSoonAsAnyOther) {
  const auto rendered = render(test::Scene());
  for (const double extent : {1e4, 2147483647.0, 1e19, 1e300, std::numeric_limits<double>::infinity(),
                              std::numeric_limits<double>::quiet_NaN()}) {
    SCOPED_TRACE(extent);
    MarkObservation wide = rendered.observation();
    // Another print in the right view, so that the first guess does not do.
    test::Scene other;
    other.other_texture_in_right = true;
    const auto contradictory = render(other);
    for (const test::RenderedMark* marks : {&rendered, &contradictory}) {
      wide = marks->observation();
      wide.left.width = wide.right.width = extent;
      locate_every_way(wide, test::default_camera());
      wide = marks->observation();
      wide.left.height = wide.right.height = extent;
      locate_every_way(wide, test::default_camera());
      wide = marks->observation();
      wide.left.x = extent;
      locate_every_way(wide, test::default_camera());
      wide = marks->observation();
      wide.right.x = wide.right.y = -extent;
      locate_every_way(wide, test::default_camera());
      wide = marks->observation();
      wide.left.patch.frame.x = wide.left.patch.frame.y = extent;
      locate_every_way(wide, test::default_camera());
      wide = marks->observation();
      wide.left.patch.frame.scale = wide.right.patch.frame.scale = extent;
      locate_every_way(wide, test::default_camera());
    }
  }
}

TEST(ExtremeMark, SeenByACameraBeyondAllMeasureIsNotLocatedBeyondWhatAMessageCarries) {
  const auto rendered = render(test::Scene());
  using Limits = std::numeric_limits<double>;
  for (const double extreme : {Limits::denorm_min(), Limits::min(), 1e-154, 1e-9, 1e9, 1e154, Limits::max(), 0.0, -1.0,
                               Limits::infinity(), Limits::quiet_NaN()}) {
    for (double geometry::StereoCamera::*field :
         {&geometry::StereoCamera::fx, &geometry::StereoCamera::fy, &geometry::StereoCamera::cx_left,
          &geometry::StereoCamera::cx_right, &geometry::StereoCamera::cy, &geometry::StereoCamera::baseline}) {
      geometry::StereoCamera camera = test::default_camera();
      camera.*field = extreme;
      for (const Location& location : locate_every_way(rendered.observation(), camera)) {
        EXPECT_LE(location.p_C.cwiseAbs().maxCoeff(), 1e4);
        EXPECT_LE(location.covariance.cwiseAbs().maxCoeff(), 4e5);
      }
    }
  }
}

}  // namespace
}  // namespace markservo::target_locator
