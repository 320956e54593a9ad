#include "services/stack-watch/supervisor/command_line.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

namespace markservo::stack_watch {
namespace {

constexpr const char* kUrl = "udpm://239.255.76.67:7667?ttl=0";

TEST(CommandLine, OfAServiceOnThisBusMustSpeak) {
  EXPECT_TRUE(must_speak({"/a b/bin/visual-servo", "--lcm-url", kUrl}, "visual-servo", kUrl));
  EXPECT_TRUE(must_speak({"visual-servo", std::string("--lcm-url=") + kUrl}, "visual-servo", kUrl));
  EXPECT_TRUE(must_speak({"visual-servo", "--robot", "r1"}, "visual-servo", kUrl))
      << "the bus that all take by default";
}

TEST(CommandLine, OfWhatRunsAServiceNeedNotSpeak) {
  EXPECT_FALSE(must_speak({"/bin/bash", "/run/launch/visual-servo"}, "visual-servo", kUrl));
  EXPECT_FALSE(must_speak({"gdb", "/bin/visual-servo"}, "visual-servo", kUrl));
  EXPECT_FALSE(must_speak({}, "visual-servo", kUrl)) << "it is gone";
}

TEST(CommandLine, ThatNamesAnotherBusNeedNotSpeakHere) {
  for (const std::string option : {"--lcm-url", "--lcm-out"}) {
    EXPECT_FALSE(must_speak({"visual-servo", option, "memq://"}, "visual-servo", kUrl)) << option;
    EXPECT_FALSE(must_speak({"visual-servo", option + "=memq://"}, "visual-servo", kUrl)) << option;
  }
}

TEST(CommandLine, IsReadOfAProcess) {
  EXPECT_FALSE(command_line_of(getpid()).empty());
  EXPECT_TRUE(command_line_of(1 << 23).empty()) << "beyond the kernel's largest number";
}

}  // namespace
}  // namespace markservo::stack_watch
