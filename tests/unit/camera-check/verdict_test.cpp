#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "services/camera-check/camera_check.hpp"
#include "services/camera-check/marks/mark_messages.hpp"
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

  // Of one colour, with that much noise, smoothed by `blur_px` (0: white).
  static cv::Mat wall(unsigned seed, double noise, double blur_px = 0.0) {
    cv::Mat picture(480, 640, CV_32FC3);
    cv::RNG(seed).fill(picture, cv::RNG::NORMAL, 0.0, 1.0);
    if (blur_px > 0.0) cv::GaussianBlur(picture, picture, cv::Size(), blur_px);
    cv::Scalar mean;
    cv::Scalar deviation;
    cv::meanStdDev(picture, mean, deviation);
    picture.convertTo(picture, CV_8U, noise / deviation[0], 128.0);
    return picture;
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
  const std::vector<Finding> findings = findings_of(report_of(wall(1, 3.0), wall(2, 3.0), 0.0));
  EXPECT_THAT(wrong(findings), testing::IsEmpty());
  for (const char* what : {"too few edges to tell whether it is sharp", "too little to be seen to tell"}) {
    EXPECT_THAT(findings, testing::Contains(testing::Field(&Finding::what, testing::HasSubstr(what))));
  }
}

// As of cameras that filter their pictures, or of pictures that were rectified.
TEST_F(Verdict, OfABareWallIsNothingWrongWhateverItsNoise) {
  for (const double blur_px : {0.4, 0.7}) {
    for (const double noise : {0.0, 1.0, 8.0, 20.0}) {
      const cv::Mat left = wall(1, noise, blur_px);
      EXPECT_EQ(fault_of(left, wall(2, noise, blur_px)), "")
          << noise << " levels, correlated over " << blur_px << " px";
    }
  }
}

// A mark of one colour is all there is to be seen: too little for a verdict on the cameras.
TEST_F(Verdict, OfAPlainMarkBeforeABareWallIsThatNothingIsWrong) {
  cv::Mat left = wall(1, 3.0);
  cv::Mat right = wall(2, 3.0);
  cv::rectangle(left, cv::Rect(300, 200, 70, 90), cv::Scalar(40, 60, 200), cv::FILLED);
  cv::rectangle(right, cv::Rect(260, 200, 70, 90), cv::Scalar(40, 60, 200), cv::FILLED);
  EXPECT_EQ(fault_of(left, right), "");
}

// Of one mark in so many pairs.
MarkSightings sightings(MarkStatus status, bool left, bool right, int pairs = 3) {
  MarkSightings marks;
  for (int i = 0; i < pairs; ++i) {
    marks.add(SeenMark{"red_book", left, right});
    PlacedMark placed{"red_book", status, MarkCue::kNone, 0, Eigen::Vector3d::Zero()};
    if (status == MarkStatus::kLocated) {
      placed.cue = MarkCue::kTexture;
      placed.num_points = 40;
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
  EXPECT_EQ(findings[0].what,
            "red_book: located in 3 of 3 pairs, by its texture (40 points), 0.250 m from the left lens");
}

// What is said of a mark that a message places, by what the message says that carries the position.
std::string said_of_cue(std::int8_t cue) {
  LocatedMark mark{};
  mark.name = "blue_ball";
  mark.status = LocatedMark::LOCATED;
  mark.cue = cue;
  mark.p_C.y = 0.25;
  mark.num_features = 52;
  TargetPose pose{};
  pose.marks = {mark};
  pose.num_marks = 1;
  MarkSightings marks;
  marks.add(SeenMark{"blue_ball", true, true});
  add_to(marks, pose);
  return findings_of(marks.all()).front().what;
}

TEST(VerdictOfMarks, TellsByWhatAPlainMarkIsLocated) {
  EXPECT_EQ(said_of_cue(LocatedMark::CUE_OUTLINE),
            "blue_ball: located in 1 of 1 pairs, by its outline (52 points), 0.250 m from the left lens");
  EXPECT_EQ(said_of_cue(LocatedMark::CUE_CENTROID),
            "blue_ball: located in 1 of 1 pairs, by the middle of its colour, 0.250 m from the left lens");
}

TEST(VerdictOfMarks, IsThatAMarkInViewIsNotLocatedAndWhy) {
  const std::vector<Finding> findings = findings_of(sightings(MarkStatus::kTooFewMatches, true, true).all());
  EXPECT_EQ(wrong(findings),
            std::vector<std::string>{"red_book: seen, but neither its texture nor its outline tells where (seen left "
                                     "in 3, right in 3 of 3 pairs)"});
  EXPECT_THAT(findings.front().mend, testing::HasSubstr("outline")) << "a plain mark needs no texture";
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
  marks.add(PlacedMark{"blue_book", MarkStatus::kUnseen, MarkCue::kNone, 0, Eigen::Vector3d::Zero()});
  EXPECT_TRUE(wrong(findings_of(marks.all())).empty());
}

}  // namespace
}  // namespace markservo::camera_check
