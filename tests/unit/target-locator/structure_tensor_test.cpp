#include "services/target-locator/features/structure_tensor.hpp"

#include <gtest/gtest.h>

#include <utility>
#include <vector>

#include "services/target-locator/features/features.hpp"
#include "tests/unit/target-locator/whole_mask.hpp"

namespace markservo::target_locator {
namespace {

PlaneImage ten_by_ten_square() {
  PlaneImage image(10, 10);
  for (int y = 2; y < 8; ++y) {
    for (int x = 2; x < 8; ++x) image.at(x, y) = 1.0F;
  }
  return image;
}

// scikit-image documents corner_foerstner with this picture, these thresholds (W above 0.5 with Sobel's unnormalised
// kernel, hence the 64; C above 0.3) and these four corners.
TEST(Foerstner, FindsTheFourCornersOfASquare) {
  const PlaneImage square = ten_by_ten_square();
  const CornerMeasures measures = foerstner(sobel_gradients(square, true), 0.0F);
  FeatureParameters parameters;
  parameters.min_weight = 0.5F / 64.0F;
  parameters.min_roundness = 0.3F;
  std::vector<std::pair<int, int>> corners;
  for (const Feature& feature : find_features(measures, test::whole_mask(10, 10), parameters)) {
    corners.emplace_back(feature.row, feature.column);
  }
  EXPECT_EQ(corners, (std::vector<std::pair<int, int>>{{2, 2}, {2, 7}, {7, 2}, {7, 7}}));
}

TEST(Foerstner, GivesAFlatPatchNeitherWeightNorRoundness) {
  const CornerMeasures measures = foerstner(sobel_gradients(PlaneImage(20, 20, 80.0F)), 1.0F);
  for (int y = 0; y < 20; ++y) {
    for (int x = 0; x < 20; ++x) {
      EXPECT_EQ(measures.weight.at(x, y), 0.0F);
      EXPECT_EQ(measures.roundness.at(x, y), 0.0F);
    }
  }
}

TEST(Foerstner, RemembersNothingOfTheImageBefore) {
  Gradients gradients;
  CornerMeasures measures;
  for (int height = 20; height < 26; ++height) {
    PlaneImage textured(20, height);
    for (int y = 0; y < height; ++y) {
      for (int x = 0; x < 20; ++x) textured.at(x, y) = static_cast<float>((x * 7 + y * 13) * (x + y) % 97);
    }
    sobel_gradients(textured, false, gradients);
    foerstner(gradients, 1.0F, measures);
    sobel_gradients(PlaneImage(20, height, 80.0F), false, gradients);
    foerstner(gradients, 1.0F, measures);
    for (int y = 0; y < height; ++y) {
      for (int x = 0; x < 20; ++x) ASSERT_EQ(measures.weight.at(x, y), 0.0F) << height << " " << x << " " << y;
    }
  }
}

TEST(Foerstner, FloorsTheTraceWhereGradientsAreFaint) {
  PlaneImage faint = ten_by_ten_square();
  EXPECT_GT(foerstner(sobel_gradients(faint), 0.0F).roundness.at(2, 2), 0.3F);
  EXPECT_EQ(foerstner(sobel_gradients(faint), 1.0F).roundness.at(2, 2), 0.0F);
}

TEST(Foerstner, CallsAnEdgeNotRound) {
  PlaneImage edge(20, 20);
  for (int y = 0; y < 20; ++y) {
    for (int x = 10; x < 20; ++x) edge.at(x, y) = 100.0F;
  }
  const CornerMeasures measures = foerstner(sobel_gradients(edge), 1.0F);
  EXPECT_LT(measures.roundness.at(10, 10), 1e-4F);
  EXPECT_LT(measures.weight.at(10, 10), 1e-2F);
}

TEST(SobelGradients, AreInGreyLevelsPerPixel) {
  PlaneImage ramp(9, 7);
  for (int y = 0; y < 7; ++y) {
    for (int x = 0; x < 9; ++x) ramp.at(x, y) = 3.0F * static_cast<float>(x) - 2.0F * static_cast<float>(y);
  }
  const Gradients gradients = sobel_gradients(ramp);
  EXPECT_FLOAT_EQ(gradients.column.at(4, 3), 3.0F);
  EXPECT_FLOAT_EQ(gradients.row.at(4, 3), -2.0F);
}

CornerMeasures measures_with_peaks(const std::vector<Feature>& peaks, int size) {
  CornerMeasures measures{PlaneImage(size, size), PlaneImage(size, size, 1.0F), {}};
  for (const Feature& peak : peaks) measures.weight.at(peak.column, peak.row) = peak.weight;
  return measures;
}

TEST(Features, AreLocalMaximaInsideTheMask) {
  const CornerMeasures measures = measures_with_peaks({{5, 5, 20.0F}, {6, 5, 30.0F}, {15, 15, 40.0F}}, 20);
  Mask mask = test::whole_mask(20, 20);
  mask.set(15, 15, false);
  const auto features = find_features(measures, mask, {});
  ASSERT_EQ(features.size(), 1U);
  EXPECT_EQ(features[0].column, 6);
  EXPECT_EQ(features[0].row, 5);
}

TEST(Features, CountAPlateauOnce) {
  EXPECT_EQ(find_features(measures_with_peaks({{5, 5, 20.0F}, {6, 5, 20.0F}}, 20), test::whole_mask(20, 20), {}).size(),
            1U);
}

TEST(Features, SpreadOverTheMarkInsteadOfCrowdingWhereTextureIsStrong) {
  std::vector<Feature> peaks;
  for (int k = 0; k < 8; ++k) peaks.push_back({2 + 2 * (k % 4), 2 + 2 * (k / 4), 100.0F});
  peaks.push_back({35, 5, 10.0F});
  peaks.push_back({5, 35, 10.0F});
  peaks.push_back({35, 35, 10.0F});
  FeatureParameters parameters;
  parameters.max_features = 4;
  const auto features = find_features(measures_with_peaks(peaks, 40), test::whole_mask(40, 40), parameters);
  ASSERT_EQ(features.size(), 4U);
  EXPECT_EQ(features[1].column, 35);
  EXPECT_EQ(features[2].row, 35);
  EXPECT_EQ(features[3].row, 35);
}

}  // namespace
}  // namespace markservo::target_locator
