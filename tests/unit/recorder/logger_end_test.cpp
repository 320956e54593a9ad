#include "services/recorder/logger/logger_end.hpp"

#include <gtest/gtest.h>

#include <csignal>

namespace markservo::recorder {
namespace {

using Who = LoggerEnd::Who;

TEST(LoggerEnd, IsSaidInWords) {
  EXPECT_EQ(text_of({Who::kLogger, true, SIGSEGV}), "lcm-logger was killed by signal 11 (SIGSEGV)");
  EXPECT_EQ(text_of({Who::kKeeper, true, SIGKILL}),
            "keep-logger, which runs lcm-logger, was killed by signal 9 (SIGKILL)");
  EXPECT_EQ(text_of({Who::kLogger, false, 1}), "lcm-logger ended with exit code 1");
  EXPECT_EQ(text_of({Who::kLogger, true, 63}), "lcm-logger was killed by signal 63 (SIG?)");
}

TEST(LoggerEnd, HasAShellsExitCode) {
  EXPECT_EQ((LoggerEnd{Who::kLogger, true, SIGKILL}.exit_code()), 137);
  EXPECT_EQ((LoggerEnd{Who::kLogger, false, 3}.exit_code()), 3);
}

TEST(LoggerEnd, IsTheLoggersOwnWordOnlyWhereItEndedByItselfWithAFault) {
  EXPECT_TRUE((LoggerEnd{Who::kLogger, false, 1}.is_own_word()));
  EXPECT_FALSE((LoggerEnd{Who::kLogger, false, 0}.is_own_word()));
  EXPECT_FALSE((LoggerEnd{Who::kLogger, true, 1}.is_own_word()));
  EXPECT_TRUE(LoggerEnd{}.is_well());
}

TEST(LoggerEnd, IsToldByTheKeepersExitCode) {
  for (const LoggerEnd& end : {LoggerEnd{Who::kLogger, true, SIGKILL}, LoggerEnd{Who::kLogger, true, SIGSYS},
                               LoggerEnd{Who::kLogger, false, 0}, LoggerEnd{Who::kLogger, false, 127}}) {
    const LoggerEnd told = told_by_keeper(keeper_exit_code(end));
    EXPECT_EQ(told.by_signal, end.by_signal);
    EXPECT_EQ(told.number, end.number);
    EXPECT_EQ(told.who, Who::kLogger);
  }
  EXPECT_EQ(keeper_exit_code({Who::kLogger, true, SIGKILL}), 201);
}

}  // namespace
}  // namespace markservo::recorder
