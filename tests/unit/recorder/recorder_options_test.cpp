#include "services/recorder/recorder_options.hpp"

#include <gtest/gtest.h>

#include "services/recorder/refusal.hpp"
#include "tests/unit/recorder/scratch_folder.hpp"

namespace markservo::recorder {
namespace {

constexpr const char* kUrl = "udpm://239.255.76.67:7667?ttl=0&recv_buf_size=4194304";

class Options : public ::testing::Test {
 protected:
  Options() { folder_.write("config/robot.yaml", "arm: {}\n"); }

  RecorderOptions parsed(std::vector<std::string> words) const {
    words.insert(words.begin(),
                 {"--config-dir", folder_.path("config"), "--robot-file", folder_.path("config/robot.yaml")});
    return parse_command_line(words, kUrl);
  }

  // What is said to them; empty: nothing.
  std::string objection(const std::vector<std::string>& words) const {
    try {
      parsed(words);
    } catch (const UsageError& error) {
      EXPECT_EQ(error.code(), 2);
      return error.what();
    }
    return {};
  }

  ScratchFolder folder_{"recorder_options_test"};
};

TEST_F(Options, HaveDefaults) {
  const RecordingPlan plan = parsed({}).plan;
  EXPECT_EQ(plan.lcm_url, kUrl);
  EXPECT_TRUE(plan.frames);
  EXPECT_EQ(plan.duration_s, std::nullopt);
  EXPECT_EQ(plan.min_free_mb, 500);
}

TEST_F(Options, AreTakenWithAndWithoutAnEqualsSign) {
  const RecorderOptions options = parsed({"--for=010", "--split-mb", "5", "--keep=2", "--note", "--help",
                                          "--robot=", "--without-frames", "--out", "a=b", "--min-free", "0"});
  EXPECT_EQ(options.plan.duration_s, 10);
  EXPECT_EQ(options.plan.split_mb, 5);
  EXPECT_EQ(options.plan.keep_parts, 2);
  EXPECT_EQ(options.plan.note, "--help");
  EXPECT_EQ(options.plan.robot, "");
  EXPECT_FALSE(options.plan.frames);
  EXPECT_EQ(options.out, "a=b");
  EXPECT_EQ(options.plan.min_free_mb, 0);
}

TEST_F(Options, CountAsTheyWereGivenLast) {
  EXPECT_EQ(parsed({"--note", "one", "--note=[two]"}).plan.note, "[two]");
}

TEST_F(Options, AskForAReceiveBufferThatRawFramesNeed) {
  EXPECT_EQ(parsed({"--lcm-url", "udpm://?ttl=1"}).plan.lcm_url, "udpm://?ttl=1&recv_buf_size=4194304");
}

TEST_F(Options, AreRefusedWithTheValueAndWhatIsAllowed) {
  EXPECT_EQ(objection({"--for", "soon"}), "--for soon; allowed: 1 to 99999999");
  EXPECT_EQ(objection({"--for", "-1"}), "--for -1; allowed: 1 to 99999999");
  EXPECT_EQ(objection({"--for", ""}), "--for ; allowed: 1 to 99999999");
  EXPECT_EQ(objection({"--split-mb", "1000001"}), "--split-mb 1000001; allowed: 1 to 1000000");
  EXPECT_EQ(objection({"--split-mb", "99999999999999999999"}),
            "--split-mb 99999999999999999999; allowed: 1 to 1000000");
  EXPECT_EQ(objection({"--min-free", "1.5"}), "--min-free 1.5; allowed: 0 to 99999999");
  EXPECT_EQ(objection({"--keep", "3"}), "--keep needs --split-mb");
  EXPECT_EQ(objection({"--name", "a", "--out", "b"}), "--name and --out: one of them");
  EXPECT_EQ(objection({"--name", "../x"}), "--name '../x'; allowed: letters, digits, . _ and -, but not 'latest'");
  EXPECT_NE(objection({"--name", "latest"}), "");
  EXPECT_NE(objection({"--name", ".hidden"}), "");
  EXPECT_EQ(objection({"--robot", "a/b"}), "--robot 'a/b'; allowed: letters, digits, _ and -");
  EXPECT_EQ(objection({"--lcm-url", "memq://"}), "--lcm-url 'memq://'; allowed: udpm:// and tcpq:// URLs");
  EXPECT_EQ(objection({"--robot-file", "/no/such.yaml"}), "--robot-file /no/such.yaml: no such file");
  EXPECT_EQ(objection({"--config-dir", "/no/such"}), "--config-dir /no/such: no such folder");
}

TEST_F(Options, ThatAreNoneAreNamed) {
  EXPECT_EQ(objection({"--increment", "3"}), "unknown argument '--increment'");
  EXPECT_EQ(objection({"folder"}), "unknown argument 'folder'");
  EXPECT_EQ(objection({"--for"}), "--for needs a value");
}

}  // namespace
}  // namespace markservo::recorder
