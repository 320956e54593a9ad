#include "services/target-locator/mark_locator.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <random>

#include "tests/unit/target-locator/synthetic_mark.hpp"

namespace markservo::target_locator {
namespace {

using test::Scene;

Location locate(const Scene& scene, Method method = Method::kRefined, double size = 0.025) {
  const auto rendered = render(scene);
  LocatorParameters parameters;
  parameters.method = method;
  return locate_mark(rendered.observation(Surface::kPlane, size), scene.camera, parameters);
}

struct Draws {
  double sum = 0.0;   // m
  double max = 0.0;   // m
  double nees = 0.0;  // summed
  int located = 0;
  int drawn = 0;

  double mean() const { return sum / std::max(1, located); }
  double mean_nees() const { return nees / std::max(1, located); }
};

// Marks at 15 to 35 cm, facing the cameras and slanted by 20 degrees either way, noise sigma 3.
Draws measure(Method method, int per_setting) {
  Draws draws;
  for (const double depth : {0.15, 0.20, 0.25, 0.30, 0.35}) {
    for (int slant = 0; slant < 3; ++slant) {
      for (int k = 0; k < per_setting; ++k) {
        Scene scene;
        scene.seed = static_cast<unsigned>(1000.0 * depth) * 37U + static_cast<unsigned>(slant) * 101U +
                     static_cast<unsigned>(k) * 7U;
        std::mt19937 generator(scene.seed);
        std::uniform_real_distribution<double> offset(-0.5, 0.5);
        scene.centre = {0.0325 + 0.01 * offset(generator), depth + 0.004 * offset(generator), 0.02 * offset(generator)};
        scene.yaw_deg = slant == 1 ? 20.0 : 0.0;
        scene.pitch_deg = slant == 2 ? 20.0 : 0.0;
        const Location found = locate(scene, method);
        ++draws.drawn;
        if (found.status != Status::kLocated) continue;
        ++draws.located;
        const Eigen::Vector3d error = found.p_C - scene.centre;
        draws.sum += error.norm();
        draws.max = std::max(draws.max, error.norm());
        draws.nees += error.dot(found.covariance.inverse() * error);
      }
    }
  }
  return draws;
}

TEST(LocateMark, MeasuresTheCentreToATenthOfAMillimetreAndSaysHowWell) {
  const Draws draws = measure(Method::kRefined, 6);
  RecordProperty("mean_mm", std::to_string(1e3 * draws.mean()));
  RecordProperty("max_mm", std::to_string(1e3 * draws.max));
  RecordProperty("mean_nees", std::to_string(draws.mean_nees()));
  EXPECT_EQ(draws.located, draws.drawn);
  EXPECT_LT(draws.mean(), 0.06e-3);
  EXPECT_LT(draws.max, 0.2e-3);
  // Three degrees of freedom: 3 if the covariance is right.
  EXPECT_GT(draws.mean_nees(), 2.0);
  EXPECT_LT(draws.mean_nees(), 4.5);
}

TEST(LocateMark, AsInThePaperWorksAndIsWorse) {
  const Draws paper = measure(Method::kPaper, 1);
  RecordProperty("mean_mm", std::to_string(1e3 * paper.mean()));
  EXPECT_EQ(paper.located, paper.drawn);
  EXPECT_LT(paper.mean(), 10e-3);
  EXPECT_GT(paper.mean(), 0.3e-3);
}

TEST(LocateMark, TellsThePlanesNormalToADegree) {
  Scene scene;
  scene.yaw_deg = -20.0;
  scene.pitch_deg = 15.0;
  const Location found = locate(scene);
  ASSERT_EQ(found.status, Status::kLocated);
  EXPECT_GT(found.normal_C.dot(scene.normal()), std::cos(1.0 * 3.14159 / 180.0));
}

TEST(LocateMark, GivesTheMatchesBehindThePosition) {
  const Location found = locate(Scene());
  ASSERT_GE(found.matches.size(), 12U);
  const Scene scene;
  const double disparity = scene.camera.fx * scene.camera.baseline / scene.centre.y();
  for (const Match& match : found.matches) {
    EXPECT_NEAR(match.u_left - match.u_right, disparity, 0.4);
    EXPECT_NEAR(match.v_left, match.v_right, 0.2);
    EXPECT_LT(match.residual, 0.36);
  }
}

TEST(LocateMark, AnswersTheSameForTheSameInput) {
  const auto rendered = test::render(Scene());
  const Location a = locate_mark(rendered.observation(), Scene().camera, {});
  const Location b = locate_mark(rendered.observation(), Scene().camera, {});
  EXPECT_EQ(a.p_C, b.p_C);
  EXPECT_EQ(a.covariance, b.covariance);
  EXPECT_EQ(a.matches.size(), b.matches.size());
}

TEST(LocateMark, BearsPairsThatAreRectifiedBadlyByAPixel) {
  Scene scene;
  scene.right_row_shift = 1.0;
  const Location found = locate(scene);
  ASSERT_EQ(found.status, Status::kLocated);
  EXPECT_LT((found.p_C - scene.centre).norm(), 0.4e-3);  // half of the pixel is a true ambiguity of the height
}

TEST(LocateMark, BearsCamerasOfDifferentGain) {
  Scene scene;
  scene.right_gain = 0.75;
  const Location found = locate(scene);
  ASSERT_EQ(found.status, Status::kLocated);
  EXPECT_LT((found.p_C - scene.centre).norm(), 0.15e-3);
}

// Its centre cannot be told well, and that is what the covariance must say.
TEST(LocateMark, IsUnsureOfAMarkThatIsPartlyHidden) {
  const Location whole = locate(Scene());
  Scene scene;
  scene.hidden_share = 0.2;
  const Location hidden = locate(scene);
  ASSERT_EQ(whole.status, Status::kLocated);
  ASSERT_EQ(hidden.status, Status::kLocated);
  const Eigen::Vector3d error = hidden.p_C - scene.centre;
  EXPECT_GT(error.norm(), 1e-3);
  EXPECT_GT(hidden.covariance.trace(), 100.0 * whole.covariance.trace());
  EXPECT_LT(error.dot(hidden.covariance.inverse() * error), 16.0);
}

TEST(LocateMark, RejectsAnotherMarkOfTheSameColour) {
  Scene scene;
  scene.other_texture_in_right = true;
  const Location found = locate(scene);
  EXPECT_TRUE(found.status == Status::kInconsistent || found.status == Status::kTooFewMatches);
  EXPECT_EQ(found.p_C, Eigen::Vector3d::Zero());
}

TEST(LocateMark, RejectsViewsOnDifferentRowsOfDifferentSizesOrBehindTheCameras) {
  const Scene scene;
  const auto rendered = test::render(scene);
  MarkObservation rows = rendered.observation();
  rows.right.y += 60.0;
  EXPECT_EQ(locate_mark(rows, scene.camera, {}).status, Status::kInconsistent);
  MarkObservation sizes = rendered.observation();
  sizes.right.height *= 0.3;
  EXPECT_EQ(locate_mark(sizes, scene.camera, {}).status, Status::kInconsistent);
  MarkObservation swapped = rendered.observation();
  std::swap(swapped.left, swapped.right);
  EXPECT_EQ(locate_mark(swapped, scene.camera, {}).status, Status::kInconsistent);
}

TEST(LocateMark, SaysThatATexturedMarkIsMeasuredByItsTexture) {
  EXPECT_EQ(locate({}).cue, Cue::kTexture);
}

// Before a wall whose shade changes. The rays that drew it end at eighths of a pixel, which an outline shows.
TEST(LocateMark, MeasuresAMarkWithoutTextureByItsOutline) {
  Scene scene;
  scene.texture_depth = 0.0;
  const Location found = locate(scene);
  ASSERT_EQ(found.status, Status::kLocated);
  EXPECT_EQ(found.cue, Cue::kOutline);
  const Eigen::Vector3d error = found.p_C - scene.centre;
  EXPECT_LT(error.norm(), 0.08e-3);
  EXPECT_LT(std::sqrt(found.covariance(1, 1)), 0.02e-3);
}

TEST(LocateMark, SaysWhichViewsLackTheMark) {
  const Scene scene;
  const auto rendered = test::render(scene);
  MarkObservation none;
  EXPECT_EQ(locate_mark(none, scene.camera, {}).status, Status::kUnseen);
  MarkObservation one = rendered.observation();
  one.right = View();
  EXPECT_EQ(locate_mark(one, scene.camera, {}).status, Status::kSeenByOne);
  MarkObservation clipped = rendered.observation();
  clipped.left.clipped = true;
  const Location found = locate_mark(clipped, scene.camera, {});
  EXPECT_EQ(found.status, Status::kClipped);
  EXPECT_FALSE(found.matches.empty());
}

TEST(LocateMark, RefusesImpossibleCameras) {
  const Scene scene;
  const auto rendered = test::render(scene);
  for (int broken = 0; broken < 6; ++broken) {
    geometry::StereoCamera camera = scene.camera;
    double* const fields[] = {&camera.fx, &camera.fy, &camera.cx_left, &camera.cx_right, &camera.cy, &camera.baseline};
    *fields[broken] = std::numeric_limits<double>::quiet_NaN();
    EXPECT_FALSE(valid_camera(camera));
    EXPECT_NE(locate_mark(rendered.observation(), camera, {}).status, Status::kLocated);
  }
  geometry::StereoCamera camera = scene.camera;
  camera.baseline = -0.065;
  EXPECT_FALSE(valid_camera(camera));
}

// Whatever the patches hold, there is an answer.
TEST(LocateMark, SurvivesStrangePatches) {
  const Scene scene;
  const auto rendered = test::render(scene);
  const std::vector<std::uint8_t> zeros(70000, 0);
  const std::vector<std::uint8_t> ones(70000, 255);
  std::vector<std::uint8_t> noise(70000);
  std::mt19937 generator(3);
  for (auto& byte : noise) byte = static_cast<std::uint8_t>(generator());
  const std::array<const std::vector<std::uint8_t>*, 3> contents = {&zeros, &ones, &noise};
  for (const Method method : {Method::kRefined, Method::kPaper}) {
    for (const Surface surface : {Surface::kPlane, Surface::kFree, Surface::kBall}) {
      LocatorParameters parameters;
      parameters.method = method;
      for (const int side : {1, 2, 3, 7, 8, 9, 12, 40, 128}) {
        for (const auto* bgr : contents) {
          for (const auto* mask : contents) {
            for (const bool both : {false, true}) {
              MarkObservation odd = rendered.observation(surface);
              odd.left.patch.width = odd.left.patch.height = side;
              odd.left.patch.bgr = bgr->data();
              odd.left.patch.mask = mask->data();
              if (both) odd.right.patch = odd.left.patch;
              EXPECT_NO_THROW(locate_mark(odd, scene.camera, parameters));
            }
          }
        }
      }
      MarkObservation far = rendered.observation(surface);
      far.right.patch.frame.x = 1e9;
      EXPECT_NE(locate_mark(far, scene.camera, parameters).status == Status::kLocated && method == Method::kRefined,
                true);
      MarkObservation without = rendered.observation(surface);
      without.right.patch = Patch();
      EXPECT_EQ(locate_mark(without, scene.camera, parameters).status, Status::kTooFewMatches);
    }
  }
}

TEST(LocateMark, LocatesAFlatMarkAlsoWhenItIsCalledFree) {
  const Scene scene;
  const auto rendered = test::render(scene);
  const Location found = locate_mark(rendered.observation(Surface::kFree), scene.camera, {});
  ASSERT_EQ(found.status, Status::kLocated);
  EXPECT_EQ(found.normal_C, Eigen::Vector3d::Zero());
  EXPECT_NEAR(found.p_C.y(), scene.centre.y(), 1e-3);
  EXPECT_LT((found.p_C - scene.centre).norm(), 6e-3);
}

TEST(LocateMark, WorksOnPatchesAveragedByTwoAndByThree) {
  Scene scene;
  scene.centre = {0.03, 0.17, 0.0};
  for (const int limit : {80, 50}) {
    const auto rendered = test::render(scene, limit);
    EXPECT_GE(rendered.left.view.patch.frame.scale, 2.0);
    const Location found = locate_mark(rendered.observation(), scene.camera, {});
    ASSERT_EQ(found.status, Status::kLocated) << limit;
    EXPECT_LT((found.p_C - scene.centre).norm(), 0.3e-3) << limit;
  }
}

}  // namespace
}  // namespace markservo::target_locator
