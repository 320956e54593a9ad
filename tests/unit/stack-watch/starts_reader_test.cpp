#include "services/stack-watch/supervisor/starts_reader.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

namespace markservo::stack_watch {
namespace {

class Starts : public ::testing::Test {
 protected:
  Starts() { std::filesystem::create_directories(folder_ / "starts"); }
  ~Starts() override { std::filesystem::remove_all(folder_); }

  SupervisedProcess after(const std::string& text) const {
    std::ofstream(folder_ / "starts" / "arm") << text;
    SupervisedProcess process;
    process.name = "arm";
    note_starts((folder_ / "supervisor.sock").string(), process);
    return process;
  }

  static double up_s() {
    double seconds = 0.0;
    std::ifstream("/proc/uptime") >> seconds;
    return seconds;
  }

  std::filesystem::path folder_ = std::filesystem::temp_directory_path() / ("starts_test." + std::to_string(getpid()));
};

TEST_F(Starts, TellHowOftenAProcessCrashedAndUntilWhenItsNextStartIsWaitedFor) {
  const auto in_100_s = static_cast<long>(100.0 * (up_s() + 100.0));
  const SupervisedProcess process = after("3 " + std::to_string(in_100_s) + "\n");
  EXPECT_EQ(process.crashes, 3);
  EXPECT_NEAR(process.next_start_s, 100.0, 30.0) << "this machine may be slow";
}

TEST_F(Starts, ThatAreNotToBeReadTellNothing) {
  for (const char* text : {"", "x y\n", "3\n"}) {
    EXPECT_EQ(after(text).crashes, 0) << text;
    EXPECT_EQ(after(text).next_start_s, 0.0) << text;
  }
}

}  // namespace
}  // namespace markservo::stack_watch
