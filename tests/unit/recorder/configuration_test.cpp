#include "services/recorder/manifest/configuration.hpp"

#include <gtest/gtest.h>

namespace markservo::recorder {
namespace {

TEST(KeptPath, IsWithinTheConfigurationWhereverItLies) {
  EXPECT_EQ(kept_path("/etc/markservo/scenes/shelf.yaml", "/etc/markservo", "/usr/share/markservo"),
            "config/scenes/shelf.yaml");
  EXPECT_EQ(kept_path("/p/config/robot.yaml", "/p/config", "/p"), "config/robot.yaml");
}

TEST(KeptPath, IsWithinTheProject) {
  EXPECT_EQ(kept_path("/p/tests/robot.yaml", "/p/config", "/p"), "tests/robot.yaml");
  EXPECT_EQ(kept_path("/p/config-of-mine/robot.yaml", "/p/config", "/p"), "config-of-mine/robot.yaml");
}

TEST(KeptPath, IsNeverAbsolute) {
  EXPECT_EQ(kept_path("/elsewhere/robot.yaml", "/p/config", "/p"), "outside/robot.yaml");
  EXPECT_EQ(kept_path("/p-of-another/robot.yaml", "/p/config", "/p"), "outside/robot.yaml");
}

// The sums are those of sha256sum.
TEST(Configuration, HasTheTextAndSumOfEachFileAndASumOfAll) {
  const Json json = configuration_json({{"config/a", "abc"}, {"config/empty", ""}});
  EXPECT_EQ(json["files"][0]["path"], "config/a");
  EXPECT_EQ(json["files"][0]["text"], "abc");
  EXPECT_EQ(json["files"][0]["sha256"], "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  EXPECT_EQ(json["files"][1]["sha256"], "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  EXPECT_EQ(json["sha256"], "9e0e0d7b9865a8ad799ad6e4efb9a0c3e71a2e6c869865a36a6e35728ae1abe5");
}

}  // namespace
}  // namespace markservo::recorder
