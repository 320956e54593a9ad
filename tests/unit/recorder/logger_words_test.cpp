#include "services/recorder/logger/logger_words.hpp"

#include <gtest/gtest.h>

namespace markservo::recorder {
namespace {

TEST(WordFilter, LeavesOutTheLinesThatSayThatAllIsWell) {
  WordFilter filter;
  EXPECT_EQ(filter.lines_of("Opening log file \"x\"\n\nSummary: all 5 events\nDisk full!\nLogger exiting\n"),
            "Disk full!\n");
}

TEST(WordFilter, PutsLinesTogether) {
  WordFilter filter;
  EXPECT_EQ(filter.lines_of("Summ"), "");
  EXPECT_EQ(filter.lines_of("ary: x\nself te"), "");
  EXPECT_EQ(filter.lines_of("st failed\nand"), "self test failed\n");
  EXPECT_EQ(filter.rest(), "and\n");
  EXPECT_EQ(filter.rest(), "");
}

TEST(WordFilter, DoesNotKeepALineWithoutAnEnd) {
  WordFilter filter;
  EXPECT_EQ(filter.lines_of(std::string(5000, 'x')), std::string(5000, 'x') + "\n");
}

TEST(LoggerWords, JudgeTheLoggerThatRunsByItsOwnWordsOnly) {
  LoggerWords words;
  words.begin_run();
  words.add("LCM self test failed!!\n");
  EXPECT_TRUE(words.says_self_test_failed());
  EXPECT_TRUE(words.says_no_route());
  words.begin_run();
  EXPECT_FALSE(words.says_self_test_failed());
  words.add("\nis there a multicast route?\nmore\n");
  EXPECT_TRUE(words.says_no_route());
  EXPECT_EQ(words.first_line(), "is there a multicast route?");
}

TEST(LoggerWords, TellOfTheDiskWhoeverSaidSo) {
  LoggerWords words;
  EXPECT_EQ(words.first_line(), "nothing");
  words.add("Can't write to log fast enough\nwrite: No space left on device\n");
  words.begin_run();
  EXPECT_TRUE(words.says_disk_was_slow());
  EXPECT_TRUE(words.says_disk_is_full());
}

TEST(LoggerWords, AreKeptForTheManifestUpToALimit) {
  LoggerWords words;
  words.add("one\n");
  words.begin_run();
  words.add("two\n\n");
  EXPECT_EQ(words.all(), "one\ntwo");
  for (int i = 0; i < 10'000; ++i) words.add("dropped\n");
  EXPECT_LE(words.all().size(), 10'000U);
}

}  // namespace
}  // namespace markservo::recorder
