#include "common/text/text.hpp"

#include <gtest/gtest.h>

#include <string>

namespace markservo::text {
namespace {

using namespace std::string_literals;

const std::string kEuro = "\xE2\x82\xAC";

TEST(Text, OfAnyLanguageMayStand) {
  for (const std::string& text : {""s, "book on the left"s, "Bücher, 本"s, "\xF0\x9F\x93\x96"s}) {
    EXPECT_EQ(violation("reason", text), "");
    EXPECT_EQ(cleaned(text), text);
    EXPECT_EQ(printable(text), text);
  }
}

TEST(Text, IsAtMost200BytesLong) {
  EXPECT_EQ(violation("reason", std::string(200, 'x')), "");
  EXPECT_EQ(violation("reason", std::string(201, 'x')), "reason is 201 bytes long; allowed: at most 200");
}

TEST(Text, WithControlCharactersMayNotStand) {
  for (const std::string& harmful :
       {"\x1b[2J"s, "a\nb"s, "\r"s, "\t"s, "\0"s, "\x7f"s, "\xC2\x80"s, "\xC2\x9B"s, "\xC2\x9F"s}) {
    EXPECT_NE(violation("reason", harmful), "") << printable(harmful);
    EXPECT_EQ(violation("reason", cleaned(harmful)), "");
    EXPECT_EQ(violation("reason", printable(harmful)), "");
  }
  EXPECT_EQ(violation("reason", "\xC2\xA0"), "") << "the first beyond C1";
}

TEST(Text, WithMarksOfDirectionMayNotStand) {
  for (const std::string& harmful : {"\xD8\x9C"s, "\xE2\x80\x8E"s, "\xE2\x80\x8F"s, "\xE2\x80\xAA"s, "\xE2\x80\xAE"s,
                                     "\xE2\x81\xA6"s, "\xE2\x81\xA9"s}) {
    EXPECT_NE(violation("reason", harmful), "") << printable(harmful);
    EXPECT_EQ(cleaned(harmful), "?");
  }
  for (const std::string& beside : {"\xE2\x80\x8D"s, "\xE2\x80\x90"s, "\xE2\x80\xAF"s, "\xE2\x81\xA5"s}) {
    EXPECT_EQ(violation("reason", beside), "") << "next to a mark of direction";
  }
}

TEST(Text, ThatIsNotUtf8MayNotStand) {
  for (const std::string& harmful :
       {"\xff"s, "\x80"s, "\xC3"s, "\xC0\xAF"s, "\xE0\x80\xAF"s, "\xED\xA0\x80"s, "\xF4\x90\x80\x80"s, "\xE2\x82"s}) {
    EXPECT_NE(violation("reason", harmful), "") << printable(harmful);
    EXPECT_EQ(cleaned(harmful), std::string(harmful.size(), '?'));
  }
}

TEST(Text, IsADecimalNumberAsPeopleWriteIt) {
  for (const char* number : {"0", "7", "640", "-640", "+3", "-0"}) EXPECT_TRUE(is_decimal(number)) << number;
  for (const char* other : {"", "-", "+-1", "0640", "-010", "00", "0x10", "1.5", "1e3", " 1", "one"}) {
    EXPECT_FALSE(is_decimal(other)) << other;
  }
}

TEST(Text, RefusalSaysWhatAndWhere) {
  EXPECT_EQ(violation("reason", "no\x1b"),
            "reason holds \\x1b at byte 2; allowed: UTF-8 without control characters and marks of direction");
}

TEST(Text, TooLongIsCutBetweenTwoCharacters) {
  std::string euros;
  for (int i = 0; i < 100; ++i) euros += kEuro;
  const std::string cut = cleaned(euros);
  EXPECT_LE(cut.size(), kMaxBytes);
  EXPECT_GE(cut.size(), kMaxBytes - 3) << "no shorter than it must be";
  EXPECT_EQ(violation("reason", cut), "");
  EXPECT_EQ(cut.substr(cut.size() - 3), "...");
  EXPECT_EQ(cleaned(std::string(200, 'x')), std::string(200, 'x'));
  EXPECT_EQ(cleaned(std::string(8 << 20, 'x')), std::string(197, 'x') + "...");
}

TEST(Text, CleanedKeepsItsWords) {
  EXPECT_EQ(cleaned("no route\nto host\x1b[31m"), "no route to host [31m");
}

TEST(Text, PrintedShowsWhatItHeld) {
  EXPECT_EQ(printable("a\nb\r\t\x1b[2J\x07\xE2\x80\xAE\xff\xC2\x9B\0z"s),
            "a\\nb\\r\\t\\x1b[2J\\x07\\u202e\\xff\\u009b\\x00z");
  EXPECT_EQ(printable(std::string(1000, 'x')).size(), 1000U);
}

}  // namespace
}  // namespace markservo::text
