#include "services/stereo-camera/files/picture_list.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/robot/configuration_error.hpp"
#include "tests/unit/temporary_folder.hpp"

namespace markservo::stereo_camera {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

std::vector<long> numbers(const std::vector<NumberedPicture>& pictures) {
  std::vector<long> result;
  for (const auto& picture : pictures) result.push_back(picture.number);
  return result;
}

// "place path, ..."
std::string told(const std::vector<PlacedPicture>& pictures) {
  std::string text;
  for (const auto& picture : pictures) text += std::to_string(picture.place) + " " + picture.path + ", ";
  return text;
}

class PicturePattern : public testing::Test {
 protected:
  void touch(const std::vector<std::string>& names) const {
    for (const std::string& name : names) folder_.write(name, "x");
  }
  test::TemporaryFolder folder_;
};

TEST_F(PicturePattern, FindsFilesByRisingNumberAcrossGaps) {
  touch({"a_10.png", "a_02.png", "a_01.png", "a_4.png", "b_03.png", "a_05.jpg", "a_123.png", "a_0123.png", "a_x1.png"});
  EXPECT_THAT(numbers(expand_pattern(folder_.file("a_%02d.png"), "--left")), ElementsAre(1, 2, 10, 123));
}

TEST_F(PicturePattern, WithoutAWidthTakesNumbersWithoutZeros) {
  touch({"a7.png", "a07.png", "a0.png", "a12.png"});
  EXPECT_THAT(numbers(expand_pattern(folder_.file("a%d.png"), "--left")), ElementsAre(0, 7, 12));
}

TEST_F(PicturePattern, WithoutANumberIsOneFile) {
  touch({"a.png"});
  EXPECT_EQ(expand_pattern(folder_.file("a.png"), "--left").size(), 1U);
  EXPECT_THROW(expand_pattern(folder_.file("absent.png"), "--left"), ConfigurationError);
}

TEST_F(PicturePattern, ThatMatchesNothingIsAnErrorWithTheOptionsName) {
  touch({"a_01.png"});
  for (const std::string pattern : {"b_%02d.png", "absent/a_%02d.png"}) {
    try {
      expand_pattern(folder_.file(pattern), "--left");
      FAIL() << pattern;
    } catch (const ConfigurationError& error) {
      EXPECT_THAT(error.what(), HasSubstr("--left"));
      EXPECT_THAT(error.what(), HasSubstr("no file matches"));
    }
  }
}

TEST_F(PicturePattern, MayHaveNothingButOneNumber) {
  for (const std::string pattern :
       {"a_%s.png", "a_%n.png", "a_%2d.png", "a_%00d.png", "a_%012d.png", "a_%d_%d.png", "a_%"}) {
    EXPECT_THROW(expand_pattern(folder_.file(pattern), "--left"), ConfigurationError) << pattern;
  }
}

TEST(PicturePairs, AreTheNumbersThatBothSidesHave) {
  const auto paired = pair_by_number({{1, "l1"}, {2, "l2"}, {4, "l4"}}, {{1, "r1"}, {3, "r3"}, {4, "r4"}, {5, "r5"}});
  EXPECT_EQ(told(paired.left), "0 l1, 3 l4, ");
  EXPECT_EQ(told(paired.right), "0 r1, 3 r4, ");
  EXPECT_EQ(paired.note, "left has 3 pictures, right has 4; only the 2 with a partner are used");
}

// Somebody chose these, or the camera counts so: nothing says that any is lost.
TEST(PicturePairs, WhoseNumbersNeitherSideHasLeaveNoGap) {
  EXPECT_EQ(told(pair_by_number({{10, "a"}, {20, "b"}}, {{10, "A"}, {20, "B"}}).left), "0 a, 1 b, ");
  EXPECT_EQ(told(placed({{10, "a"}, {20, "b"}})), "0 a, 1 b, ");
}

TEST(PicturePairs, AreQuietWhereAllHavePartners) {
  EXPECT_EQ(pair_by_number({{1, "l"}}, {{1, "r"}}).note, "");
}

TEST(PicturePairs, NeedANumberInCommon) {
  EXPECT_THROW(pair_by_number({{1, "l"}}, {{2, "r"}}), ConfigurationError);
}

TEST(PictureName, IsToldFromAVideosByItsEnd) {
  EXPECT_TRUE(is_picture_name("x/left.PNG"));
  EXPECT_TRUE(is_picture_name("left_%03d.raw"));
  EXPECT_FALSE(is_picture_name("left.avi"));
  EXPECT_FALSE(is_picture_name("a.png/left"));
}

}  // namespace
}  // namespace markservo::stereo_camera
