#include <gtest/gtest.h>

#include <algorithm>

#include "services/camera-check/camera_check.hpp"
#include "services/camera-check/marks/mark_sightings.hpp"
#include "tests/unit/camera-check/scene_pair.hpp"

namespace markservo::camera_check {
namespace {

std::vector<std::string> wrong(const std::vector<Finding>& findings) {
  std::vector<std::string> texts;
  for (const Finding& each : findings) {
    EXPECT_EQ(each.ok, each.mend.empty()) << each.what;
    if (!each.ok) texts.push_back(each.what);
  }
  return texts;
}

// The only thing that is wrong with the pair, or all of them.
std::string fault_of(const cv::Mat& left, const cv::Mat& right) {
  std::string text;
  for (const std::string& each : wrong(findings_of(report_of(left, right, 0.0))))
    text += (text.empty() ? "" : "; ") + each;
  return text;
}

class Verdict : public ::testing::Test {
 protected:
  static bool begins(const std::string& text, const std::string& beginning) { return text.rfind(beginning, 0) == 0; }

  cv::Mat scaled(const cv::Mat& picture, double factor) const {
    cv::Mat result;
    picture.convertTo(result, CV_8U, factor);
    return result;
  }

  scenes::StereoPair scene_ = scene_pair();
};

TEST_F(Verdict, OfAGoodPairIsWell) {
  EXPECT_EQ(fault_of(scene_.left, scene_.right), "");
}

TEST_F(Verdict, OfAPairWithoutLightIsThatItIsDarkAndNoMore) {
  const std::string fault = fault_of(scaled(scene_.left, 0.1), scaled(scene_.right, 0.1));
  EXPECT_TRUE(begins(fault, "the left picture is dark")) << fault;
  EXPECT_NE(fault.find("; the right picture is dark"), std::string::npos) << fault;
  EXPECT_EQ(std::count(fault.begin(), fault.end(), ';'), 1) << fault;
}

TEST_F(Verdict, OfACappedLensNamesItsSide) {
  const std::string fault = fault_of(scene_.left, scaled(scene_.right, 0.02));
  EXPECT_TRUE(begins(fault, "the right picture is dark")) << fault;
}

TEST_F(Verdict, OfAPictureThatIsBlownOutIsThatItIsTooBright) {
  const std::string fault = fault_of(scaled(scene_.left, 20.0), scene_.right);
  EXPECT_TRUE(begins(fault, "the left picture is too bright")) << fault;
}

TEST_F(Verdict, OfSidesThatDifferInTheirLightNamesTheDarker) {
  const std::string fault = fault_of(scene_.left, scaled(scene_.right, 0.4));
  EXPECT_TRUE(begins(fault, "the right picture is much darker than the other")) << fault;
}

TEST_F(Verdict, OfABlurredPairNamesBothSides) {
  const scenes::StereoPair soft = scene_pair(3.5);
  const std::string fault = fault_of(soft.left, soft.right);
  EXPECT_TRUE(begins(fault, "the left picture is blurred")) << fault;
  EXPECT_NE(fault.find("the right picture is blurred"), std::string::npos) << fault;
}

TEST_F(Verdict, OfOneBlurredSideNamesIt) {
  const std::string fault = fault_of(scene_.left, scene_pair(3.0).right);
  EXPECT_TRUE(begins(fault, "the right picture is blurred")) << fault;
}

TEST_F(Verdict, OfAnExchangedPairIsThat) {
  const std::string fault = fault_of(scene_.right, scene_.left);
  EXPECT_TRUE(begins(fault, "left and right are exchanged")) << fault;
}

TEST_F(Verdict, OfRowsThatAreOffSaysByHowMuch) {
  const std::string fault = fault_of(scene_.left, moved(scene_.right, 4.0));
  EXPECT_TRUE(begins(fault, "rows are off: the right picture shows the same point 4.0 px lower")) << fault;
}

TEST_F(Verdict, OfOneCameraNamedTwiceIsThat) {
  EXPECT_EQ(fault_of(scene_.left, scene_.left), "both pictures are the same");
}

TEST_F(Verdict, OfACameraUpsideDownIsThatThePicturesShowDifferentThings) {
  cv::Mat turned;
  cv::rotate(scene_.right, turned, cv::ROTATE_180);
  const std::string fault = fault_of(scene_.left, turned);
  EXPECT_TRUE(begins(fault, "the two pictures show different things")) << fault;
}

TEST_F(Verdict, OfABareWallIsThatNothingCanBeTold) {
  cv::Mat wall(480, 640, CV_8UC3);
  cv::RNG(1).fill(wall, cv::RNG::NORMAL, 128.0, 3.0);
  cv::Mat other(480, 640, CV_8UC3);
  cv::RNG(2).fill(other, cv::RNG::NORMAL, 128.0, 3.0);
  const std::vector<Finding> findings = findings_of(report_of(wall, other, 0.0));
  EXPECT_TRUE(std::any_of(findings.begin(), findings.end(), [](const Finding& each) {
    return each.what.find("too few edges to tell whether it is sharp") != std::string::npos;
  }));
}

// Of one mark in so many pairs.
MarkSightings sightings(MarkStatus status, bool left, bool right, int pairs = 3) {
  MarkSightings marks;
  for (int i = 0; i < pairs; ++i) {
    marks.add(SeenMark{"red_book", left, right});
    PlacedMark placed{"red_book", status, "", Eigen::Vector3d::Zero()};
    if (status == MarkStatus::kLocated) {
      placed.cue = "texture (40 points)";
      placed.p_C = Eigen::Vector3d(0.0, 0.25, 0.0);
    }
    marks.add(placed);
  }
  return marks;
}

TEST(VerdictOfMarks, TellsHowOftenAMarkIsLocatedAndByWhat) {
  const std::vector<Finding> findings = findings_of(sightings(MarkStatus::kLocated, true, true).all());
  ASSERT_EQ(findings.size(), 1U);
  EXPECT_TRUE(findings[0].ok);
  EXPECT_EQ(findings[0].what, "red_book: located in 3 of 3 pairs, by texture (40 points), 0.250 m from the left lens");
}

TEST(VerdictOfMarks, IsThatAMarkInViewIsNotLocatedAndWhy) {
  const std::vector<Finding> findings = findings_of(sightings(MarkStatus::kTooFewMatches, true, true).all());
  EXPECT_EQ(wrong(findings),
            std::vector<std::string>{"red_book: seen, but too few of its points match (seen left in 3, "
                                     "right in 3 of 3 pairs)"});
}

TEST(VerdictOfMarks, IsThatNoneIsLocatedWhereNoneIsInView) {
  const std::vector<Finding> findings = findings_of(sightings(MarkStatus::kSeenByOne, true, false).all());
  ASSERT_EQ(findings.size(), 2U);
  EXPECT_EQ(findings[0].what, "red_book: seen by one camera only (seen left in 3, right in 0 of 3 pairs)");
  EXPECT_EQ(wrong(findings), std::vector<std::string>{"no mark is located"});
}

TEST(VerdictOfMarks, IsWellWhereOneIsLocatedAndAnotherOutOfView) {
  MarkSightings marks = sightings(MarkStatus::kLocated, true, true);
  marks.add(SeenMark{"blue_book", false, false});
  marks.add(PlacedMark{"blue_book", MarkStatus::kUnseen, "", Eigen::Vector3d::Zero()});
  EXPECT_TRUE(wrong(findings_of(marks.all())).empty());
}

}  // namespace
}  // namespace markservo::camera_check
