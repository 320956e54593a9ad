// STOP and ABORT are obeyed whatever else the message says; RESET, START and HOME are not.

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <markservo/JointState.hpp>
#include <markservo/StopRequest.hpp>
#include <markservo/TaskCommand.hpp>
#include <string>

#include "tests/unit/messages/violation.hpp"

namespace markservo::messages {
namespace {

StopRequest request(std::int8_t kind) {
  StopRequest request{};
  request.session = 7;
  request.request_id = 1;
  request.kind = kind;
  return request;
}

TEST(StopRules, StopIsMendedInsteadOfRefused) {
  StopRequest stop = request(StopRequest::STOP);
  stop.utime = std::numeric_limits<std::int64_t>::min();
  stop.session = -1;
  stop.source = std::string(1 << 20, '\x1b');
  stop.reason = "smoke\n" + std::string(1000, 'x');
  ASSERT_EQ(broken_rule(stop).rfind("utime is ", 0), 0U) << broken_rule(stop);
  EXPECT_TRUE(mend_if_it_must_be_obeyed(stop));
  EXPECT_EQ(stop.kind, StopRequest::STOP);
  EXPECT_EQ(stop.utime, 0) << "an impossible time is unknown";
  EXPECT_EQ(stop.session, -1) << "what is echoed stays as it was asked";
  EXPECT_LE(stop.source.size(), 200U);
  EXPECT_LE(stop.reason.size(), 200U);
  EXPECT_EQ(stop.reason.substr(0, 7), "smoke x");
}

TEST(StopRules, StopKeepsATimeThatMayBeTrue) {
  StopRequest stop = request(StopRequest::STOP);
  for (const std::int64_t utime : {std::int64_t{0}, std::int64_t{1}, kMaxCount}) {
    stop.utime = utime;
    EXPECT_TRUE(mend_if_it_must_be_obeyed(stop));
    EXPECT_EQ(stop.utime, utime);
  }
}

TEST(StopRules, ResetAndUnknownKindsAreNotMended) {
  for (const std::int8_t kind : {StopRequest::RESET, std::int8_t{2}, std::int8_t{-1}}) {
    StopRequest other = request(kind);
    other.reason = std::string(1000, 'x');
    EXPECT_FALSE(mend_if_it_must_be_obeyed(other));
    EXPECT_EQ(other.reason.size(), 1000U);
    EXPECT_EQ(broken_rule(other), "reason is 1000 bytes long; allowed: at most 200");
  }
  EXPECT_EQ(broken_rule(request(StopRequest::RESET)), "");
}

TEST(StopRules, ResetThatNobodySentIsRefused) {
  StopRequest reset = request(StopRequest::RESET);
  reset.session = 0;
  EXPECT_NE(broken_rule(reset).find("session"), std::string::npos);
}

TEST(StopRules, AbortLosesAllButItsKind) {
  TaskCommand abort{};
  abort.kind = TaskCommand::ABORT;
  abort.utime = -5;
  abort.target = "book\x1b";
  abort.expected_known = 1;
  abort.p_CT_expected.x = NAN;
  abort.drive = 1;
  abort.drive_pose.heading = INFINITY;
  ASSERT_EQ(broken_rule(abort), "utime is -5; allowed: 0 to 2^53 us");
  EXPECT_TRUE(mend_if_it_must_be_obeyed(abort));
  abort.session = 7;
  EXPECT_EQ(broken_rule(abort), "");
  EXPECT_EQ(abort.drive, 0);
}

TEST(StopRules, StartAndHomeAreNotMended) {
  for (const std::int8_t kind : {TaskCommand::START, TaskCommand::HOME, TaskCommand::DRIVE}) {
    TaskCommand command{};
    command.session = 7;
    command.kind = kind;
    EXPECT_EQ(broken_rule(command), "");
    command.target = std::string(201, 'x');
    EXPECT_FALSE(mend_if_it_must_be_obeyed(command));
    EXPECT_NE(broken_rule(command).find("target"), std::string::npos);
  }
}

TEST(StopRules, NothingElseMustBeObeyed) {
  JointState state{};
  EXPECT_FALSE(mend_if_it_must_be_obeyed(state));
}

}  // namespace
}  // namespace markservo::messages
