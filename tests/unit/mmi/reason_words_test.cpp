#include "services/mmi/scene/reason_words.hpp"

#include <gtest/gtest.h>

namespace markservo::mmi {
namespace {

TEST(ReasonWords, AreTheReasonWithoutItsNumbers) {
  EXPECT_EQ(reason_words("something 0.31 m ahead of the robot; it keeps 0.10 m"),
            "something # m ahead of the robot; it keeps # m");
  EXPECT_EQ(reason_words("grip point (0.1, -0.20, 3) m: 12."), "grip point (#, #, #) m: #.");
  EXPECT_EQ(reason_words("1e-05 to 2.5e+10, 3 emus"), "# to #, # emus");
}

TEST(ReasonWords, KeepTheDigitsWithinANameAndOtherSigns) {
  EXPECT_EQ(reason_words("mark book_2 of side2b - unseen"), "mark book_2 of side2b - unseen");
  EXPECT_EQ(reason_words("0x1f"), "#x1f");
  EXPECT_EQ(reason_words(""), "");
}

TEST(ReasonWords, TellOtherWordsApart) {
  EXPECT_NE(reason_words("something 0.31 m left of the robot"), reason_words("something 0.31 m right of the robot"));
  EXPECT_EQ(reason_words("late by 9.9 ms"), reason_words("late by -10.25 ms"));
}

}  // namespace
}  // namespace markservo::mmi
