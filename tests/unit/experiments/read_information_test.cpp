#include "tests/experiments/localisation/read_information.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "tests/unit/experiments/localisation_paths.hpp"

namespace markservo::experiments {
namespace {

ReaderModel reader_over(double spacing) {
  ReaderModel reader;
  reader.read_probability = 1.0;
  reader.tags = lattice(spacing, 0.5);
  return reader;
}

// Mean over the places of a standing antenna within one cell of the lattice.
ReadInformation cell_average(const ReaderModel& reader, double spacing) {
  constexpr int kPlaces = 40;  // each axis
  ReadInformation sum = ReadInformation::Zero();
  for (int i = 0; i < kPlaces; ++i) {
    for (int j = 0; j < kPlaces; ++j) {
      sum += read_information(reader, standing({spacing * i / kPlaces, spacing * j / kPlaces}), 50.0);
    }
  }
  return sum / (kPlaces * kPlaces);
}

TEST(ReadInformation, AveragesToTheClosedFormOverTheLattice) {
  const double d = 0.10;
  const ReaderModel reader = reader_over(d);
  const ReadInformation information = cell_average(reader, d);
  const double sigma = d * std::sqrt(reader.edge_softness / (M_PI * reader.reading_radius));
  EXPECT_NEAR(1.0 / std::sqrt(information(0, 0)), sigma, 0.002 * sigma);
  EXPECT_NEAR(1.0 / std::sqrt(information(1, 1)), sigma, 0.002 * sigma);
  EXPECT_NEAR(information(0, 1), 0.0, 0.01 * information(0, 0));
}

TEST(ReadInformation, SaysNothingOfHeadingWhileTheAntennaTurnsOnTheSpotOrOfTheDelayWhileItStands) {
  const ReadInformation information = read_information(reader_over(0.10), standing({0.03, 0.02}), 50.0);
  EXPECT_GT(information(0, 0), 0.0);
  EXPECT_EQ(information.row(2).norm(), 0.0);
  EXPECT_EQ(information.row(3).norm(), 0.0);
}

TEST(ReadInformation, SeesHeadingByTheLeverOfTheAntenna) {
  ReaderModel reader = reader_over(0.10);
  reader.p_RF = {0.2, 0.0};
  const ReadInformation information = read_information(reader, standing({-0.17, 0.02}), 50.0);
  EXPECT_NEAR(information(2, 2), 0.2 * 0.2 * information(1, 1), 1e-6 * information(2, 2));
}

TEST(ReadInformation, CannotTellADelayFromAWayBackAlongTheMotion) {
  const ReadInformation information = read_information(reader_over(0.10), straight({-0.2, 0.02}, 0.0, 0.4, 1.0), 0.5);
  EXPECT_NEAR(information(0, 3), -0.4 * information(0, 0), 1e-9 * information(0, 0));
  EXPECT_NEAR(information(3, 3), 0.4 * 0.4 * information(0, 0), 1e-9 * information(0, 0));
}

TEST(ReadInformation, IsLessWhileTheEdgeSmearsAlongTheMotion) {
  const ReaderModel reader = reader_over(0.10);
  double moving = 0.0;
  double still = 0.0;
  for (int i = 0; i < 20; ++i) {
    const double x = 0.005 * i;
    moving += read_information(reader, straight({x - 0.2, 0.02}, 0.0, 0.4, 1.0), 0.5)(0, 0);
    still += read_information(reader, standing({x, 0.02}), 50.0)(0, 0);
  }
  EXPECT_LT(moving, 0.9 * still);
}

TEST(ReadInformation, IsNoneFarFromTheTags) {
  EXPECT_EQ(read_information(reader_over(0.10), standing({3.0, 0.0}), 50.0).norm(), 0.0);
}

TEST(ReadInformation, StaysFiniteWhereTagsAreReadForCertain) {
  ReaderModel reader = reader_over(0.10);
  reader.edge_softness = 1e-4;
  EXPECT_TRUE(read_information(reader, standing({0.0, 0.0}), 50.0).allFinite());
}

TEST(ReadInformation, RefusesAnImpossibleReader) {
  ReaderModel reader = reader_over(0.10);
  reader.edge_softness = 0.0;
  EXPECT_THROW(read_information(reader, standing({0.0, 0.0}), 0.0), std::invalid_argument);
  reader = reader_over(0.10);
  reader.read_probability = 1.1;
  EXPECT_THROW(read_information(reader, standing({0.0, 0.0}), 0.0), std::invalid_argument);
}

}  // namespace
}  // namespace markservo::experiments
