#include "services/recorder/manifest/configuration.hpp"

#include <gtest/gtest.h>

namespace markservo::recorder {
namespace {

using Paths = std::vector<std::string>;

const ConfigurationSources kProject{"/p/config", "/p/config/robot.yaml", "/p"};

TEST(KeptPaths, AreWithinTheConfigurationWhereverItLies) {
  EXPECT_EQ(
      kept_paths({"/etc/markservo/scenes/shelf.yaml"}, {"/etc/markservo", "/etc/robot.yaml", "/usr/share/markservo"}),
      Paths{"config/scenes/shelf.yaml"});
  EXPECT_EQ(kept_paths({"/p/config/robot.yaml"}, kProject), Paths{"config/robot.yaml"});
}

TEST(KeptPaths, AreWithinTheProject) {
  EXPECT_EQ(kept_paths({"/p/tests/robot.yaml", "/p/config-of-mine/robot.yaml"}, kProject),
            (Paths{"tests/robot.yaml", "config-of-mine/robot.yaml"}));
}

TEST(KeptPaths, AreNeverAbsolute) {
  EXPECT_EQ(kept_paths({"/elsewhere/robot.yaml"}, kProject), Paths{"outside/robot.yaml"});
  EXPECT_EQ(kept_paths({"/p-of-another/robot.yaml"}, kProject), Paths{"outside/robot.yaml"});
}

TEST(KeptPaths, OfARobotFileGoBeforeThoseOfOneThatTheServicesDoNotUse) {
  EXPECT_EQ(kept_paths({"/elsewhere/mine/robot.yaml", "/elsewhere/mine/visual-servo.conf", "/p/config/robot.yaml"},
                       {"/elsewhere/mine", "/p/config/robot.yaml", "/p"}),
            (Paths{"outside/robot.yaml", "config/visual-servo.conf", "config/robot.yaml"}));
}

TEST(KeptPaths, AreNeverTheSame) {
  EXPECT_EQ(kept_paths({"/a/robot.yaml", "/b/robot.yaml", "/c/robot.yaml", "/p/outside/robot.yaml"}, kProject),
            (Paths{"outside/robot.yaml", "outside/2/robot.yaml", "outside/3/robot.yaml", "outside/4/robot.yaml"}));
}

// The sums are those of sha256sum.
TEST(Configuration, HasTheTextAndSumOfEachFileAndASumOfAll) {
  const Json json = configuration_json({{"config/a", "abc"}, {"config/empty", ""}}, "config/a");
  EXPECT_EQ(json["files"][0]["path"], "config/a");
  EXPECT_EQ(json["files"][0]["text"], "abc");
  EXPECT_EQ(json["files"][0]["sha256"], "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  EXPECT_EQ(json["files"][1]["sha256"], "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  EXPECT_EQ(json["sha256"], "9e0e0d7b9865a8ad799ad6e4efb9a0c3e71a2e6c869865a36a6e35728ae1abe5");
}

TEST(Configuration, TellsWhichFileTheRobotsIs) {
  EXPECT_EQ(configuration_json({{"outside/my.yaml", ""}}, "outside/my.yaml")["robot_file"], "outside/my.yaml");
}

TEST(Configuration, NamesWhatCannotBeReadAndGoesWithoutIt) {
  const Json json = configuration_json({{"config/a", "abc"}, {"config/secret", std::nullopt}}, "config/a");
  EXPECT_EQ(json["files"].size(), 1U);
  EXPECT_EQ(json["unreadable"], Json({"config/secret"}));
  EXPECT_EQ(json["sha256"], configuration_json({{"config/a", "abc"}}, "config/a")["sha256"]);
}

}  // namespace
}  // namespace markservo::recorder
