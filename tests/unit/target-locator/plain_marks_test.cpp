// Marks of one colour through the real detector and locator. scripts/experiment plain asks the same of more draws.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "common/geometry/degrees.hpp"
#include "services/mark-detector/mark_detector.hpp"
#include "tests/scenes/area_coverage.hpp"
#include "tests/scenes/observation.hpp"
#include "tests/scenes/plain_draws.hpp"

namespace markservo::scenes {
namespace {

using target_locator::Cue;
using target_locator::Location;
using target_locator::LocatorParameters;
using target_locator::Method;
using target_locator::Status;

constexpr int kDraws = 24;
constexpr unsigned kSeed = 500;

// Of 24 draws the rms scatters by a tenth, the mean NEES by half of one.
void expect_near_the_bound(const PlainCase& what, double most) {
  const PlainTotals totals = totals_of(draw_plain_marks(what, kDraws, kSeed, {}));
  testing::Test::RecordProperty(what.name(), std::to_string(totals.ratio()));
  EXPECT_EQ(totals.missed, 0) << what.name();
  EXPECT_EQ(totals.not_by_outline, 0) << what.name();
  EXPECT_LT(totals.ratio(), 1.3 * most) << what.name();
  EXPECT_GT(totals.mean_nees, 1.3) << what.name();
  EXPECT_LT(totals.mean_nees, 5.5) << what.name();
}

TEST(PlainSquares, AreMeasuredAsWellAsTheirPixelsAllowAndSayHowWell) {
  for (const double slant_deg : {0.0, 20.0}) {
    for (const double width_px : {30.0, 60.0, 100.0})
      expect_near_the_bound({PlainForm::kSquare, width_px, slant_deg}, 1.3);
  }
}

TEST(PlainDiscs, AreMeasuredAsWellAsTheirPixelsAllowAndSayHowWell) {
  for (const double slant_deg : {0.0, 20.0}) expect_near_the_bound({PlainForm::kDisc, 60.0, slant_deg}, 1.5);
}

TEST(PlainBalls, AreMeasuredAsWellAsTheirPixelsAllowAndSayHowWell) {
  for (const double width_px : {30.0, 100.0}) expect_near_the_bound({PlainForm::kBall, width_px, 0.0}, 1.5);
}

// Packing makes pixels err together, so that the error is several times the bound of those that do not.
TEST(PlainMarks, OfFramesPackedAsJpegSayHowWellTheyAreMeasured) {
  PlainDrawParameters packed;
  packed.jpeg_quality = 90;
  double sum = 0.0;
  const std::vector<PlainCase> cases{
      {PlainForm::kSquare, 60.0, 0.0}, {PlainForm::kDisc, 60.0, 20.0}, {PlainForm::kBall, 60.0, 0.0}};
  for (const PlainCase& what : cases) {
    const PlainTotals totals = totals_of(draw_plain_marks(what, kDraws, kSeed, packed));
    EXPECT_EQ(totals.missed, 0) << what.name();
    EXPECT_LT(totals.mean_nees, 8.0) << what.name();
    sum += totals.mean_nees;
  }
  EXPECT_LT(sum / static_cast<double>(cases.size()), 6.0);
}

// A red mark of 60 px before a grey ground, at 0.6 m: f 600 px, B 60 mm, disparity 60 px.
class OneMark : public ::testing::Test {
 protected:
  static constexpr geometry::StereoCamera kCamera{600.0, 600.0, 319.5, 319.5, 239.5, 0.06};
  static constexpr double kSigma = 2.0;  // grey levels

  OneMark() {
    mark_.size = 0.06;
    mark_.p_C = point_at(kCamera, 360.4, 250.2, 0.6);
    mark_.around = {120.0, 120.0, 120.0};
    mark_.colour = {40.0, 40.0, 190.0};
    described_.name = "red";
    described_.size = 0.06;
    described_.colour = {345.0, 15.0, 0.4, 1.0, 0.2, 1.0};
  }

  cv::Mat picture(bool right) const { return picture_of(mark_, Eye(kCamera, right), {640, 480}); }

  Location locate(const cv::Mat3f& left, const cv::Mat3f& right, const LocatorParameters& parameters = {}) const {
    cv::RNG noise(7);
    const cv::Mat seen_left = expose(left, kSigma, noise);
    const cv::Mat seen_right = expose(right, kSigma, noise);
    mark_detector::Input input;
    input.left = view_of(seen_left);
    input.right = view_of(seen_right);
    input.stereo = kCamera;
    const mark_detector::MarkDetector detector({described_}, {});
    mark_detector::State state;
    const mark_detector::Finding& found = detector.step(input, state).marks[0];
    return target_locator::locate_mark(observation_of(found, described_), kCamera, parameters);
  }
  Location locate(const LocatorParameters& parameters = {}) const {
    return locate(picture(false), picture(true), parameters);
  }

  void expect_true(const Location& location) const {
    ASSERT_EQ(location.status, Status::kLocated);
    const Eigen::Vector3d error = location.p_C - mark_.p_C;
    EXPECT_LT(error.dot(location.covariance.inverse() * error), 16.0)
        << error.transpose() << " sigma " << location.covariance.diagonal().cwiseSqrt().transpose();
  }
  void expect_true(const Location& location, Cue cue) const {
    expect_true(location);
    EXPECT_EQ(location.cue, cue);
  }

  // Turned in its plane by `roll`, then slanted by `slant` about an upright axis.
  void turn(double roll_deg, double slant_deg) {
    mark_.axes = (Eigen::AngleAxisd(geometry::radians(slant_deg), Eigen::Vector3d::UnitZ()) *
                  Eigen::AngleAxisd(geometry::radians(roll_deg), Eigen::Vector3d::UnitY()))
                     .toRotationMatrix();
  }

  // What a camera sees where something of `colour` lies before the mark, over `share` of its edge along one of its
  // sides; `nearer` times as far as the mark, so that the left camera sees the same of it at any distance.
  cv::Mat hidden_picture(bool right, int side, double share, double nearer, double colour) const {
    cv::Mat3f view = picture(right);
    const double turned = side * 0.5 * M_PI;
    const Eigen::Vector3d out = mark_.axes * Eigen::Vector3d(std::cos(turned), 0.0, std::sin(turned));
    const Eigen::Vector3d along = mark_.axes * Eigen::Vector3d(-std::sin(turned), 0.0, std::cos(turned));
    std::vector<cv::Point2d> strip;
    for (const auto& [outwards, sideways] :
         {std::pair(0.5 - share, -0.8), {0.5 - share, 0.8}, {0.9, 0.8}, {0.9, -0.8}}) {
      const Eigen::Vector3d p_C = mark_.p_C + mark_.size * (outwards * out + sideways * along);
      strip.push_back(Eye(kCamera, right).image_of(nearer * p_C));
    }
    const cv::Mat1f covered = blurred_coverage(strip, {{0, 0}, view.size()}, mark_.blur_px);
    view.forEach([&](cv::Vec3f& pixel, const int* at) {
      pixel += covered(at[0], at[1]) * (cv::Vec3f::all(static_cast<float>(colour)) - pixel);
    });
    return std::move(view);
  }
  Location locate_hidden(int side, double share, double nearer, double colour) const {
    return locate(hidden_picture(false, side, share, nearer, colour),
                  hidden_picture(true, side, share, nearer, colour));
  }

  double mark_top_px() const {
    double top = 1e9;
    for (const cv::Point2d& p : contour_of(mark_, Eye(kCamera, false))) top = std::min(top, p.y);
    return top;
  }

  PlainMark mark_;
  robot::MarkDescription described_;
};

TEST_F(OneMark, ThatIsPlainIsAtSixHundredMillimetres) {
  const Location location = locate();
  expect_true(location, Cue::kOutline);
  EXPECT_NEAR(location.p_C.y(), 0.6, 0.3e-3);
  EXPECT_LT(std::sqrt(location.covariance(1, 1)), 0.2e-3);
  EXPECT_EQ(location.matches.size(), 4U);
  EXPECT_GT(location.normal_C.dot(-Eigen::Vector3d::UnitY()), 0.99);
}

TEST_F(OneMark, IsMeasuredWhateverSizeIsStated) {
  described_.size = 0.05;
  expect_true(locate(), Cue::kOutline);
}

TEST_F(OneMark, ThatIsHiddenInPartIsNotTakenForASquareThatIsSeenWhole) {
  // A fifth of it, from above, by what looks like the ground.
  const auto hide = [&](cv::Mat3f view) {
    const int top = static_cast<int>(mark_top_px());
    view.rowRange(0, top + 12).setTo(cv::Scalar(120.0, 120.0, 120.0));
    return view;
  };
  EXPECT_NE(locate(hide(picture(false)), hide(picture(true))).cue, Cue::kOutline);
}

TEST_F(OneMark, ThatIsHiddenAlongASideSaysHowFarItsMiddleMayBe) {
  constexpr double kGround = 120.0;
  for (const double roll_deg : {0.0, 25.0}) {
    for (const double slant_deg : {0.0, 20.0}) {
      turn(roll_deg, slant_deg);
      for (const double share : {0.03, 0.05, 0.10}) {
        for (int side = 0; side < 4; ++side) {
          SCOPED_TRACE(fmt::format("roll {} slant {} share {} side {}", roll_deg, slant_deg, share, side));
          const Location location = locate_hidden(side, share, 1.0, kGround);
          expect_true(location, Cue::kOutline);
          // The side that is hidden may be the one opposite: half a strip's width either way.
          EXPECT_LT(std::sqrt(location.covariance.trace()), 0.6 * share * mark_.size + 0.5e-3);
        }
      }
    }
  }
}

TEST_F(OneMark, ThatSomethingNearerHidesOtherwiseInEitherViewSaysHowFarItsMiddleMayBe) {
  constexpr double kOther = 90.0;
  for (const double roll_deg : {0.0, 25.0}) {
    turn(roll_deg, 0.0);
    for (const double share : {0.03, 0.05, 0.10}) {
      for (const double nearer : {0.98, 0.95}) {
        for (int side = 0; side < 4; ++side) {
          SCOPED_TRACE(fmt::format("roll {} share {} nearer {} side {}", roll_deg, share, nearer, side));
          const Location location = locate_hidden(side, share, nearer, kOther);
          if (location.status == Status::kLocated) expect_true(location);
        }
      }
    }
  }
}

TEST_F(OneMark, OfAnyOtherShapeIsMeasuredByItsContour) {
  mark_.form = PlainForm::kTriangle;
  described_.outline = robot::MarkOutline::kOther;
  const Location location = locate();
  expect_true(location, Cue::kOutline);
  EXPECT_NEAR(location.p_C.y(), 0.6, 1e-3);
}

TEST_F(OneMark, ThatIsTooSmallForAnOutlineIsMeasuredByItsMiddle) {
  mark_.size = described_.size = 0.008;
  const Location location = locate();
  expect_true(location, Cue::kCentroid);
  EXPECT_NEAR(location.p_C.y(), 0.6, 10e-3);
}

TEST_F(OneMark, ThatIsSoThinThatNothingIsWellInsideIsMeasuredByItsMiddle) {
  mark_.size = 0.04;
  described_.size = 0.0;
  mark_.axes = Eigen::AngleAxisd(geometry::radians(83.5), Eigen::Vector3d::UnitX()).toRotationMatrix();
  expect_true(locate(), Cue::kCentroid);
}

// Something of the mark's colour far behind it can be as large as the mark would be there.
TEST_F(OneMark, IsNotTakenForANarrowThingOfItsColourAndArea) {
  mark_.size = 0.04;
  for (const double share : {0.6, 0.65, 0.7}) {
    described_.size = mark_.size * std::sqrt(1.0 - share);
    for (int side = 0; side < 4; ++side) {
      EXPECT_NE(locate_hidden(side, share, 1.0, 120.0).status, Status::kLocated) << share << " " << side;
    }
  }
}

TEST_F(OneMark, IsSurerInItsRowByTheMeanOfBothViewsMiddlesThanInItsColumn) {
  mark_.size = 0.008;
  described_.size = 0.0088;  // as it looks in its blur, so that nothing seems to be missing
  mark_.p_C = point_at(kCamera, kCamera.cx_left + 0.4, kCamera.cy + 0.3, 0.6);
  const Location location = locate();
  expect_true(location, Cue::kCentroid);
  EXPECT_LT(location.covariance(2, 2), 0.97 * location.covariance(0, 0));
}

TEST_F(OneMark, IsFoundAtItsCornersByThePapersMethod) {
  LocatorParameters paper;
  paper.method = Method::kPaper;
  const Location location = locate(paper);
  ASSERT_EQ(location.status, Status::kLocated);
  EXPECT_EQ(location.cue, Cue::kOutline);
  EXPECT_NEAR(location.p_C.y(), 0.6, 30e-3);
}

}  // namespace
}  // namespace markservo::scenes
