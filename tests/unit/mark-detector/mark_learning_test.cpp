// A colour learned, and what is said of it.

#include "services/mark-detector/learning/mark_learning.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "tests/unit/mark-detector/mark_pair.hpp"

namespace markservo::mark_detector {
namespace {

using namespace test;

class MarkLearningTest : public ::testing::Test {
 protected:
  MarkLearningTest() {
    picture_.draw({200.0, 100.0, 60.0, 0.0, {40.0, 110.0, 200.0}, 0.2});
    picture_.expose(1.0, 3.0);
  }
  MarkLearning learn(const LearningPicture& boxed, std::size_t mark = 1) const {
    return learn_mark(four_marks(), mark, {boxed}, {}, {});
  }

  Picture picture_{320, 240, kGrey};
};

TEST_F(MarkLearningTest, FindsTheMarkInItsBoxByTheNewColour) {
  const MarkLearning learned = learn({picture_.view(), 165, 65, 70, 70});
  EXPECT_EQ(learned.colour.failure, "");
  EXPECT_EQ(learned.colour.interval.hue_min_deg,
            learn_colour({{picture_.view(), 165, 65, 70, 70}}, {}).interval.hue_min_deg);
  ASSERT_EQ(learned.views.size(), 1U);
  EXPECT_EQ(learned.views[0].doubt, "");
  EXPECT_TRUE(learned.views[0].found.test(200, 100));
  EXPECT_FALSE(learned.views[0].found.test(167, 67)) << "the wall in the box's corner";
}

TEST_F(MarkLearningTest, HasNoViewsOfAColourThatItDoesNotFind) {
  const MarkLearning learned = learn({picture_.view(), 10, 10, 40, 40});
  EXPECT_NE(learned.colour.failure.find("has a hue"), std::string::npos) << learned.colour.failure;
  EXPECT_TRUE(learned.views.empty());
}

TEST_F(MarkLearningTest, NamesTheMarksThatItsColourOverlaps) {
  const MarkLearning learned = learn({picture_.view(), 165, 65, 70, 70}, 3);
  ASSERT_EQ(learned.overlaps.size(), 2U) << "neither green nor what it was itself";
  EXPECT_EQ(learned.overlaps[0].name, "red");
  EXPECT_EQ(learned.overlaps[0].text.rfind("blue overlaps red, hue_deg: [345.0, 15.0], ", 0), 0U)
      << learned.overlaps[0].text;
  EXPECT_EQ(learned.overlaps[1].name, "yellow");
}

TEST_F(MarkLearningTest, RefusesAMarkThatIsNotThere) {
  EXPECT_THROW(learn({picture_.view(), 165, 65, 70, 70}, 4), std::out_of_range);
}

TEST(MaskOverABox, HasABitForEachPixelOfTheBoxRowsPaddedToBytes) {
  Region found;
  found.x = 8;
  found.y = 5;
  found.width = 3;
  found.height = 2;
  found.inside.reset(3, 2);
  found.inside.set_run(0, 0, 3);
  found.inside.set_run(1, 1, 2);
  LearningPicture picture;
  picture.x = 0;
  picture.y = 4;
  picture.width = 10;
  picture.height = 3;
  const BoxMask mask = mask_over_box(found, picture);
  EXPECT_EQ(mask.bits, (std::vector<std::uint8_t>{0x00, 0x00, 0x00, 0x03, 0x00, 0x02}))
      << "column 10 lies beside the box";
  EXPECT_DOUBLE_EQ(mask.covered, 3.0 / 30.0);
}

TEST(MaskOverABox, IsEmptyWhereNothingIsFound) {
  LearningPicture picture;
  picture.width = 8;
  picture.height = 1;
  const BoxMask mask = mask_over_box({}, picture);
  EXPECT_EQ(mask.bits, std::vector<std::uint8_t>{0});
  EXPECT_EQ(mask.covered, 0.0);
}

}  // namespace
}  // namespace markservo::mark_detector
