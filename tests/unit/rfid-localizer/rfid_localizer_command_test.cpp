// rfid-localizer, the executable: robot files it refuses, and a recorded drive, twice.

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>
#include <markservo/RfidTagHits.hpp>
#include <markservo/WheelOdometry.hpp>

#include <algorithm>
#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <lcm/lcm-cpp.hpp>
#include <markservo/RobotPose.hpp>
#include <utility>
#include <vector>

#include "tests/unit/rfid-localizer/ideal_drive.hpp"

namespace markservo::rfid_localizer {
namespace {

namespace fs = std::filesystem;
using test::IdealDrive;

constexpr char kRobotFile[] = MARKSERVO_SOURCE_DIR "/config/robot.yaml";

struct Answer {
  int exit_code = -1;
  std::string text;  // both outputs
};

using Events = std::vector<std::pair<std::string, std::string>>;  // channel, payload

class RfidLocalizerCommand : public ::testing::Test {
 protected:
  RfidLocalizerCommand() : folder_(fs::temp_directory_path() / ("markservo-localizer-" + std::to_string(getpid()))) {
    fs::create_directories(folder_);
    std::ifstream file(kRobotFile);
    text_ = {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  }
  ~RfidLocalizerCommand() override { fs::remove_all(folder_); }

  std::string path(const std::string& name) const { return (folder_ / name).string(); }

  // robot.yaml with its first `from` replaced.
  void change(const std::string& from, const std::string& to) {
    const auto at = text_.find(from);
    ASSERT_NE(at, std::string::npos) << from;
    text_.replace(at, from.size(), to);
  }

  // `arguments` as a shell reads them, on the changed robot.yaml, with the drive's log in and `out` out.
  Answer run(const std::string& arguments = "", const std::string& out = "out.lcm") const {
    std::ofstream(path("robot.yaml")) << text_;
    const std::string command = std::string("'") + MARKSERVO_BIN_DIR + "/rfid-localizer' --robot-file '" +
                                path("robot.yaml") + "' --lcm-in 'file://" + path("drive.lcm") +
                                "?speed=0' --lcm-out 'file://" + path(out) + "?mode=w' " + arguments + " 2>&1";
    Answer answer;
    FILE* pipe = ::popen(command.c_str(), "r");
    if (pipe == nullptr) return answer;
    std::array<char, 4096> buffer{};
    for (std::size_t n = 0; (n = std::fread(buffer.data(), 1, buffer.size(), pipe)) > 0;) {
      answer.text.append(buffer.data(), n);
    }
    const int status = ::pclose(pipe);
    answer.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    return answer;
  }

  void expect_refusal(const std::string& expected, const std::string& arguments = "") const {
    const Answer answer = run(arguments);
    EXPECT_EQ(answer.exit_code, 2) << answer.text;
    EXPECT_NE(answer.text.find(expected), std::string::npos) << answer.text;
    EXPECT_NE(answer.text.find("allowed"), std::string::npos) << answer.text;
    EXPECT_EQ(std::count(answer.text.begin(), answer.text.end(), '\n'), 1) << answer.text;
  }

  // 4 s of a drive along the course.
  void record_drive() const {
    const IdealDrive drive(robot::load_robot_description(kRobotFile));
    lcm::LCM log("file://" + path("drive.lcm") + "?mode=w");
    for (std::int64_t tick = 1; tick <= 200; ++tick) {
      if (tick > 10 && tick % 5 == 0) {
        const RfidTagHits hits = drive.hits((tick - 10) / 5);
        log.publish("RFID_TAG_HITS", &hits);
      }
      const WheelOdometry odometry = drive.odometry(tick);
      log.publish("WHEEL_ODOMETRY", &odometry);
    }
  }

  Events events_of(const std::string& name) const {
    Events events;
    lcm::LogFile log(path(name), "r");
    while (const auto* event = log.good() ? log.readNextEvent() : nullptr) {
      events.emplace_back(event->channel,
                          std::string(static_cast<const char*>(event->data), static_cast<std::size_t>(event->datalen)));
    }
    return events;
  }

  fs::path folder_;
  std::string text_;
};

TEST_F(RfidLocalizerCommand, RefusesATagMapWithAUidTwice) {
  change("    - name: course ", R"(    - name: twice
      tags:
        - {uid: E00401500000A001, position: [0.0, 0.0]}
        - {uid: e00401500000a001, position: [0.1, 0.0]}
    - name: course )");
  expect_refusal("'E00401500000A001' twice");
}

TEST_F(RfidLocalizerCommand, RefusesATagWithoutAPosition) {
  change("    - name: course ", R"(    - name: bare
      tags: [{uid: E00401500000A001}]
    - name: course )");
  expect_refusal("position");
}

TEST_F(RfidLocalizerCommand, RefusesATagFieldThatIsNotThereAndNamesThoseThatAre) {
  expect_refusal("'cellar'", "--tag-field cellar");
  EXPECT_NE(run("--tag-field cellar").text.find("course, hall"), std::string::npos);
}

TEST_F(RfidLocalizerCommand, RefusesARobotWithoutAReaderOrWithoutTags) {
  const std::string whole = text_;
  text_ = whole.substr(0, whole.find("rfid:")) + whole.substr(whole.find("# The floor's tags"));
  expect_refusal("'rfid' is missing");
  text_ = whole.substr(0, whole.find("floor_tags:")) + whole.substr(whole.find("stop_devices:"));
  expect_refusal("'floor_tags' is missing");
}

TEST_F(RfidLocalizerCommand, RefusesOptionsOutOfRangeInOneLine) {
  for (const char* option : {"--method magic", "--delay -1", "--delay 9", "--start-heading-sigma 0", "--silence 0"}) {
    const Answer answer = run(option);
    EXPECT_EQ(answer.exit_code, 2) << option << "\n" << answer.text;
    EXPECT_EQ(std::count(answer.text.begin(), answer.text.end(), '\n'), 1) << answer.text;
  }
}

TEST_F(RfidLocalizerCommand, AnswersARecordedDriveTheSameTwice) {
  record_drive();
  ASSERT_EQ(run("", "a.lcm").exit_code, 0);
  ASSERT_EQ(run("", "b.lcm").exit_code, 0);
  const Events a = events_of("a.lcm");
  EXPECT_EQ(a.size(), 200U) << "a pose for each odometry";
  EXPECT_TRUE(a == events_of("b.lcm")) << "the answers differ";
  RobotPose last{};
  ASSERT_EQ(a.back().first, "ROBOT_POSE");
  ASSERT_GT(last.decode(a.back().second.data(), 0, static_cast<int>(a.back().second.size())), 0);
  EXPECT_EQ(last.state, RobotPose::LOCALISED);
  EXPECT_NEAR(last.pose.x, 0.2, 0.03);
  EXPECT_NEAR(last.pose.y, 0.85, 0.03);
}

// One pose per round, for want of a base that could have encoders.
TEST_F(RfidLocalizerCommand, ServesARobotWithoutADescribedBase) {
  record_drive();
  text_ = text_.substr(0, text_.find("base:\n")) + text_.substr(text_.find("# The ring of ultrasonic"));
  text_ = text_.substr(0, text_.find("stop_devices:")) + "stop_devices: [arm]\n";
  ASSERT_EQ(run("", "a.lcm").exit_code, 0);
  EXPECT_EQ(events_of("a.lcm").size(), 38U);
}

}  // namespace
}  // namespace markservo::rfid_localizer
