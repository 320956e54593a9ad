#include "common/motion/mover_watch.hpp"

#include <gtest/gtest.h>

namespace markservo::motion {
namespace {

constexpr std::int64_t kStart = 1'000'000'000;

// An arm at 100 Hz with STOP_STATE at 5 Hz, and a stream of pictures at 10 Hz, for as long as one says.
class Watched : public testing::Test {
 protected:
  struct Mover {
    std::int64_t session;
    bool latched;
    std::int64_t reports = 0;
    std::int64_t stop_states = 0;
  };

  void speak(Mover& mover, int tick) {
    const std::int64_t utime = kStart + 10'000 * tick;
    watch_.hear_report("JOINT_STATE", {mover.session, ++mover.reports, utime});
    if (tick % 20 == 0) watch_.hear_stop_state({mover.session, ++mover.stop_states, utime}, mover.latched, "");
  }
  // Until `end`; the arm obeys the STOP that the reader asks for.
  void run(int end, bool other_speaks = false) {
    for (; tick_ < end; ++tick_) {
      speak(arm_, tick_);
      if (other_speaks) speak(other_, tick_);
      if (watch_.stop_due()) arm_.latched = other_.latched = true;
    }
  }

  MoverWatch watch_{"arm"};
  Mover arm_{11, false};
  Mover other_{22, true};
  int tick_ = 0;
};

TEST_F(Watched, OneArmIsNoConflict) {
  run(500);
  EXPECT_EQ(watch_.conflict(), "");
  EXPECT_EQ(watch_.stranger(), "");
  EXPECT_EQ(watch_.latched(), false);
}

TEST_F(Watched, ASecondArmBlocksAllUntilAResetFindsOneAlone) {
  run(200);
  run(300, true);
  EXPECT_EQ(watch_.conflict(), "two write JOINT_STATE of arm: sessions 22 and 11");
  EXPECT_TRUE(arm_.latched);
  arm_.latched = other_.latched = false;  // a reset releases both
  run(400, true);
  EXPECT_NE(watch_.conflict(), "");
  EXPECT_TRUE(arm_.latched) << "stopped again";
  run(600);
  EXPECT_NE(watch_.conflict(), "") << "it never resumes by itself";
  arm_.latched = false;
  run(650);
  EXPECT_EQ(watch_.conflict(), "");
  EXPECT_EQ(watch_.session(), 11);
}

TEST_F(Watched, ARestartedArmIsNoConflict) {
  run(200);
  std::swap(arm_, other_);
  tick_ = 260;
  run(400);
  EXPECT_EQ(watch_.conflict(), "");
  EXPECT_EQ(watch_.session(), 22);
  EXPECT_EQ(watch_.latched(), true);
}

TEST_F(Watched, AStrangersReportsAreNamedForASecond) {
  run(200);
  EXPECT_EQ(watch_.hear_report("JOINT_STATE", {33, 1, kStart}), ReportHeard::kForeign);
  EXPECT_EQ(watch_.stranger(), "another writes for the arm: session 33 is not heard, 11 is");
  run(320);
  EXPECT_EQ(watch_.stranger(), "");
  EXPECT_EQ(watch_.conflict(), "");
}

TEST_F(Watched, AnOldRecordingIsNoSecondWriter) {
  run(200);
  const std::int64_t now = watch_.now();
  watch_.hear_stream("TARGET_POSE", {5, 1, now});
  EXPECT_EQ(watch_.hear_stream("TARGET_POSE", {6, 1, now - 216'000'000}), StreamHeard::kLate);
  EXPECT_EQ(watch_.hear_stream("TARGET_POSE", {5, 2, now + 1}), StreamHeard::kTaken);
}

TEST_F(Watched, TwoPictureWritersBlockToo) {
  run(200);
  const std::int64_t now = watch_.now();
  EXPECT_EQ(watch_.hear_stream("TARGET_POSE", {5, 1, now}), StreamHeard::kTaken);
  EXPECT_EQ(watch_.hear_stream("TARGET_POSE", {6, 1, now + 1}), StreamHeard::kWaits);
  EXPECT_EQ(watch_.hear_stream("TARGET_POSE", {5, 2, now + 2}), StreamHeard::kSecond);
  EXPECT_EQ(watch_.conflict(), "two write TARGET_POSE: sessions 5 and 6");
}

}  // namespace
}  // namespace markservo::motion
