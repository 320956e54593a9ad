#pragma once

// A changed copy of config/robot.yaml, for tests of what a robot file may say.

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "common/robot/configuration_error.hpp"
#include "common/robot/robot_description.hpp"

namespace markservo::robot {

class RobotFile : public ::testing::Test {
 protected:
  RobotFile()
      : path_(std::filesystem::temp_directory_path() / ("markservo-robot-" + std::to_string(getpid()) + ".yaml")) {
    std::ifstream file(MARKSERVO_SOURCE_DIR "/config/robot.yaml");
    text_ = {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  }
  ~RobotFile() override { std::filesystem::remove(path_); }

  // The file with its first `from` replaced.
  void change(const std::string& from, const std::string& to) {
    const auto at = text_.find(from);
    ASSERT_NE(at, std::string::npos) << from;
    text_.replace(at, from.size(), to);
  }

  RobotDescription load() {
    std::ofstream(path_) << text_;
    return load_robot_description(path_.string());
  }

  // The one line that refuses the file.
  std::string refusal() {
    try {
      load();
    } catch (const ConfigurationError& error) {
      std::string what = error.what();
      EXPECT_EQ(what.find('\n'), std::string::npos) << what;
      EXPECT_NE(what.find(path_.string()), std::string::npos) << what;
      EXPECT_NE(what.find("allowed"), std::string::npos) << what;
      return what;
    }
    ADD_FAILURE() << "was accepted";
    return {};
  }

  std::filesystem::path path_;
  std::string text_;
};

}  // namespace markservo::robot
