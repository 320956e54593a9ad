// mark-detector --learn, the executable, on a robot file of its own.

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <nlohmann/json.hpp>
#include <opencv2/imgcodecs.hpp>
#include <string>
#include <utility>

#include "tests/unit/mark-detector/synthetic_scene.hpp"

namespace markservo::mark_detector {
namespace {

using namespace test;
namespace fs = std::filesystem;

constexpr Colour kOrange{40.0, 110.0, 200.0};  // hue 26: neither the red book's nor the yellow one's

struct Answer {
  int exit_code = -1;
  std::string text;  // both outputs
};

class LearnCommand : public ::testing::Test {
 protected:
  LearnCommand() : folder_(fs::temp_directory_path() / ("markservo-learn-" + std::to_string(getpid()))) {
    fs::create_directories(folder_);
    fs::copy_file(std::string(MARKSERVO_SOURCE_DIR) + "/config/robot.yaml", robot_file());
    Picture picture(320, 240, kGrey);
    picture.draw({200.0, 100.0, 60.0, 0.2, kOrange, 0.2});
    write("orange.png", picture.expose(1.0, 3.0));
    write("dim.png", picture.expose(0.5, 3.0, 2));
    Picture grey(320, 240, kGrey);
    write("grey.png", grey.expose(1.0, 3.0));
  }
  ~LearnCommand() override { fs::remove_all(folder_); }

  std::string path(const std::string& name) const { return (folder_ / name).string(); }
  std::string robot_file() const { return path("robot.yaml"); }
  std::string robot_text() const {
    std::ifstream file(robot_file(), std::ios::binary);
    return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  }

  // `arguments` as a shell reads them, run in the folder; `errors`: where standard error goes.
  Answer run(const std::string& arguments, const std::string& errors = "&1") const {
    const std::string command = "cd '" + folder_.string() + "' && '" + MARKSERVO_BIN_DIR +
                                "/mark-detector' --robot-file robot.yaml " + arguments + " 2>" + errors;
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

  // Where the red book's mark is found in a picture; NaN if it is not.
  double found_u(const std::string& picture) const {
    const auto json = nlohmann::json::parse(run("--image " + picture, "/dev/null").text);
    for (const auto& mark : json["marks"]) {
      if (mark["name"] == "red_book" && mark["reason"].get<std::string>().empty()) return mark["left"]["u"];
    }
    return std::numeric_limits<double>::quiet_NaN();
  }

 private:
  void write(const std::string& name, const Picture& picture) const {
    const ImageView view = picture.view();
    cv::imwrite(path(name), cv::Mat(view.height, view.width, CV_8UC3, const_cast<std::uint8_t*>(view.bgr)));
  }

  fs::path folder_;
};

TEST_F(LearnCommand, MakesTheDetectorFindTheMark) {
  ASSERT_TRUE(std::isnan(found_u("orange.png")));
  const Answer answer = run("--learn red_book --box 165,65,70,70 orange.png dim.png");
  EXPECT_EQ(answer.exit_code, 0) << answer.text;
  EXPECT_NE(answer.text.find("red_book, old: hue_deg: [345.0, 15.0], saturation: [0.5, 1.0], value: [0.2, 1.0]"),
            std::string::npos)
      << answer.text;
  EXPECT_NE(answer.text.find("red_book, new: hue_deg: ["), std::string::npos) << answer.text;
  EXPECT_NEAR(found_u("orange.png"), 200.0, 0.5);
  EXPECT_NEAR(found_u("dim.png"), 200.0, 0.5);
}

TEST_F(LearnCommand, WorksWithoutEqualisationAsWell) {
  EXPECT_EQ(run("--no-equalise --learn red_book --box 165,65,70,70 --box 180,80,40,40 orange.png dim.png").exit_code,
            0);
  EXPECT_NEAR(found_u("dim.png --no-equalise"), 200.0, 0.5);
}

TEST_F(LearnCommand, ChangesOnlyTheMarksColourAndKeepsPermissionsAndLinks) {
  const std::string before = robot_text();
  fs::permissions(robot_file(), fs::perms::owner_read | fs::perms::owner_write | fs::perms::group_read);
  fs::rename(robot_file(), path("real.yaml"));
  fs::create_symlink("real.yaml", robot_file());
  ASSERT_EQ(run("--learn red_book --box 165,65,70,70 orange.png").exit_code, 0);
  const std::string after = robot_text();
  const std::size_t colour = before.find("colour:", before.find("name: red_book"));
  const std::size_t rest = before.find('\n', colour);
  EXPECT_EQ(after.substr(0, colour), before.substr(0, colour));
  EXPECT_EQ(after.substr(after.find('\n', colour)), before.substr(rest));
  EXPECT_NE(after, before);
  EXPECT_TRUE(fs::is_symlink(robot_file()));
  EXPECT_EQ(fs::status(robot_file()).permissions(),
            fs::perms::owner_read | fs::perms::owner_write | fs::perms::group_read);
  for (const auto& entry : fs::directory_iterator(fs::path(robot_file()).parent_path())) {
    EXPECT_EQ(entry.path().filename().string().find("yaml."), std::string::npos) << "left behind: " << entry.path();
  }
}

TEST_F(LearnCommand, WarnsOfAMarkThatIsNoLongerToldApart) {
  const Answer answer = run("--learn blue_book --box 165,65,70,70 orange.png");
  EXPECT_EQ(answer.exit_code, 0);
  EXPECT_NE(answer.text.find("warning: blue_book overlaps red_book"), std::string::npos) << answer.text;
  EXPECT_EQ(answer.text.find("overlaps hand"), std::string::npos) << answer.text;
}

TEST_F(LearnCommand, WarnsOfAMarkThatOutgrowsItsBox) {
  EXPECT_EQ(run("--learn red_book --box 165,65,70,70 orange.png").text.find("outgrows"), std::string::npos);
  const Answer answer = run("--learn red_book --box 190,90,20,20 orange.png");
  EXPECT_EQ(answer.exit_code, 0);
  EXPECT_NE(answer.text.find("warning: red_book in 'orange.png': it outgrows the box"), std::string::npos)
      << answer.text;
}

TEST_F(LearnCommand, RefusesInOneLineAndLeavesTheFile) {
  const std::string before = robot_text();
  const std::array<std::pair<const char*, const char*>, 16> cases{{
      {"--learn none --box 165,65,70,70 orange.png", "allowed: hand, red_book, yellow_book, blue_book"},
      {"--learn red_book --box 165,65,70 orange.png", "165,65,70"},
      {"--learn red_book --box 165,65,70,x orange.png", "165,65,70,x"},
      {"--learn red_book --box 165,65,70,70,3 orange.png", "165,65,70,70,3"},
      {"--learn red_book --box 165,65,0,70 orange.png", "sizes from 1"},
      {"--learn red_book --box=-1,65,70,70 orange.png", "x and y from 0"},
      {"--learn red_book --box 300,65,70,70 orange.png", "320 x 240 px"},
      {"--learn red_book --box 165,2147483647,70,70 orange.png", "320 x 240 px"},
      {"--learn red_book --box 165,65,70,70 no.png", "no.png"},
      {"--learn red_book --box 165,65,70,70 robot.yaml", "robot.yaml"},
      {"--learn red_book --box 165,65,70,70 grey.png", "has a hue"},
      {"--learn red_book --box 165,65,70,70", "no picture"},
      {"--learn red_book orange.png", "--box"},
      {"--learn red_book --box 1,1,9,9 --box 1,1,9,9 orange.png", "given 2 times"},
      {"--learn red_book --image orange.png --box 165,65,70,70 orange.png", "--image"},
      {"orange.png", "--learn"},
  }};
  for (const auto& [arguments, expected] : cases) {
    const Answer answer = run(arguments);
    EXPECT_EQ(answer.exit_code, 2) << arguments << "\n" << answer.text;
    EXPECT_NE(answer.text.find(expected), std::string::npos) << arguments << "\n" << answer.text;
    EXPECT_EQ(std::count(answer.text.begin(), answer.text.end(), '\n'), 1) << arguments << "\n" << answer.text;
    EXPECT_EQ(robot_text(), before) << arguments;
  }
}

}  // namespace
}  // namespace markservo::mark_detector
