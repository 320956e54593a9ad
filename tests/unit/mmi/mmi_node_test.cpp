#include "services/mmi/mmi_node.hpp"

#include <gtest/gtest.h>

#include <CLI/CLI.hpp>
#include <fstream>
#include <iterator>

#include "common/robot/configuration_error.hpp"
#include "tests/unit/temporary_folder.hpp"

namespace markservo::mmi {
namespace {

class MmiNodeOptions : public ::testing::Test {
 protected:
  // config/robot.yaml without anything that a STOP would stop.
  std::string robot_without_stop_devices() const {
    std::ifstream file(std::string(MARKSERVO_SOURCE_DIR) + "/config/robot.yaml");
    std::string text((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
    const std::string devices = "stop_devices: [arm, base]";
    text.replace(text.find(devices), devices.size(), "stop_devices: []");
    return folder_.write("robot.yaml", text);
  }

  static void configure(const std::string& robot_file, const std::string& options) {
    CLI::App app;
    MmiNode node;
    node.add_options(app);
    app.parse(options);
    node.configure(robot_file);
  }

  test::TemporaryFolder folder_;
};

TEST_F(MmiNodeOptions, AskForARobotThatCanBeStopped) {
  const std::string robot_file = robot_without_stop_devices();
  try {
    configure(robot_file, "");
    ADD_FAILURE() << "it was taken";
  } catch (const ConfigurationError& error) {
    EXPECT_NE(std::string(error.what()).find("stop_devices is empty"), std::string::npos) << error.what();
  }
  EXPECT_NO_THROW(configure(robot_file, "--log a.lcm"));
}

TEST_F(MmiNodeOptions, AskForATokenWhereOthersReachIt) {
  const std::string robot_file = std::string(MARKSERVO_SOURCE_DIR) + "/config/robot.yaml";
  EXPECT_THROW(configure(robot_file, "--listen 0.0.0.0:8080"), ConfigurationError);
  const std::string token = folder_.write("token", "a secret of the lab");
  EXPECT_NO_THROW(configure(robot_file, "--listen 0.0.0.0:8080 --token-file " + token));
}

}  // namespace
}  // namespace markservo::mmi
