// The example that users copy, with a log.

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <lcm/lcm-cpp.hpp>
#include <markservo/TargetPose.hpp>
#include <string>

#include "tests/unit/command.hpp"

namespace markservo {
namespace {

TEST(MarkWatcher, SaysWhereEachMarkIsOrWhyItCannotBeTold) {
  TargetPose pose{};
  pose.utime = pose.frame_utime = 1'000'000;
  pose.session = pose.seq = 1;
  pose.num_marks = 3;
  pose.marks.resize(3);
  pose.marks[0].name = "red_book";
  pose.marks[0].cue = LocatedMark::CUE_OUTLINE;
  pose.marks[0].p_C.y = 0.25;
  pose.marks[1].name = "blue_book";
  pose.marks[1].status = LocatedMark::SEEN_BY_ONE;
  pose.marks[2].name = "hand";
  pose.marks[2].status = LocatedMark::TOO_FEW_MATCHES;
  const std::string path = std::filesystem::temp_directory_path() / ("mark_watcher_test." + std::to_string(getpid()));
  {
    lcm::LCM log("file://" + path + "?mode=w");
    log.publish("TARGET_POSE", &pose);
  }
  const auto result = test::run_command("{ " MARKSERVO_BIN_DIR "/mark-watcher --lcm-in 'file://" + path +
                                        "?speed=0' --lcm-out memq:// 2>/dev/null; }");
  std::filesystem::remove(path);
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_EQ(result.output,
            "red_book x=0.0000 m y=0.2500 m z=0.0000 m, by its outline\n"
            "blue_book not located: seen by one camera only\n"
            "hand not located: seen, but neither its texture nor its outline tells where\n");
}

}  // namespace
}  // namespace markservo
