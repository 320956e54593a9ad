#include "common/robot/robot_description.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "common/robot/configuration_error.hpp"
#include "tests/unit/robot/robot_file.hpp"

namespace markservo::robot {
namespace {

TEST_F(RobotFile, OfTheProjectIsAccepted) {
  const auto robot = load();
  EXPECT_DOUBLE_EQ(robot.cameras.stereo.baseline, 0.065);
  ASSERT_TRUE(robot.arm);
  EXPECT_DOUBLE_EQ(robot.arm->upper_arm, 0.20);
  EXPECT_NEAR(robot.arm->joints[0].max, M_PI / 2.0, 1e-12);
  ASSERT_NE(robot.find_mark("red_book"), nullptr);
  EXPECT_EQ(robot.find_mark("green_book"), nullptr);
}

TEST_F(RobotFile, WithoutAnArmServesTwoCamerasAndMarks) {
  text_ = text_.substr(0, text_.find("arm:")) + text_.substr(text_.find("marks:"));
  text_ = text_.substr(0, text_.find("# What counts as a grip"));
  EXPECT_FALSE(load().arm);
}

TEST_F(RobotFile, WithAMissingKeyIsRefused) {
  change("  baseline: 0.065", "");
  EXPECT_NE(refusal().find("'cameras.baseline' is missing"), std::string::npos);
}

TEST_F(RobotFile, WithAWrongTypeIsRefused) {
  change("baseline: 0.065", "baseline: wide");
  EXPECT_NE(refusal().find("'wide'"), std::string::npos);
}

TEST_F(RobotFile, WithANegativeLengthIsRefused) {
  change("links: [0.15, 0.20, 0.20]", "links: [0.15, -0.20, 0.20]");
  EXPECT_NE(refusal().find("'arm.links[1]' is -0.20"), std::string::npos);
}

TEST_F(RobotFile, WithAnUnknownKeyIsRefused) {
  change("  baseline: 0.065", "  baseline: 0.065\n  base_line: 0.065");
  EXPECT_NE(refusal().find("'cameras.base_line' is unknown"), std::string::npos);
}

TEST_F(RobotFile, WithNotANumberIsRefused) {
  change("baseline: 0.065", "baseline: .nan");
  EXPECT_NE(refusal().find("cameras.baseline"), std::string::npos);
}

TEST_F(RobotFile, WithCamerasThatCannotBeIsRefusedWithWhatIsAllowed) {
  change("baseline: 0.065", "baseline: 65");
  EXPECT_NE(refusal().find("'cameras.baseline' is 65; allowed: a number from 0.001 to 2"), std::string::npos)
      << refusal();
  change("baseline: 65", "baseline: 0.065");
  change("fx_px: 784.0", "fx_px: 3.6e9");
  EXPECT_NE(refusal().find("'cameras.fx_px' is 3.6e9; allowed: a number from 64 to 19200"), std::string::npos)
      << refusal();
}

TEST_F(RobotFile, WithAKeyTwiceIsRefusedWithBothLines) {
  change("  baseline: 0.065", "  baseline: 0.065\n  baseline: 0.075");
  const std::string why = refusal();
  EXPECT_NE(why.find("key 'cameras.baseline' stands twice, on lines "), std::string::npos) << why;
  EXPECT_NE(why.find("; allowed: once"), std::string::npos) << why;
}

TEST_F(RobotFile, WithAKeyTwiceInAListIsRefused) {
  change("size: 0.020", "size: 0.020\n    size: 0.030");
  EXPECT_NE(refusal().find("key 'marks[0].size' stands twice"), std::string::npos) << refusal();
}

TEST_F(RobotFile, WithANumberThatYamlReadsAsOctalIsRefused) {
  change("width_px: 640", "width_px: 0640");
  EXPECT_NE(refusal().find("'cameras.width_px' is '0640'; allowed: a whole number from"), std::string::npos)
      << refusal();
}

TEST_F(RobotFile, WithASecondDocumentIsRefused) {
  text_ += "\n---\ncameras: {}\n";
  EXPECT_NE(refusal().find("holds 2 YAML documents; allowed: one"), std::string::npos) << refusal();
}

TEST_F(RobotFile, WithAnAliasWithinItselfIsRefused) {
  text_ += "\nloop: &loop [*loop]\n";
  EXPECT_NE(refusal().find("within itself"), std::string::npos) << refusal();
}

TEST_F(RobotFile, WithAMisspeltJointIsRefused) {
  change("name: shoulder", "name: sholder");
  EXPECT_NE(refusal().find("'arm.joints[1].name' is 'sholder'; allowed: shoulder"), std::string::npos) << refusal();
}

TEST_F(RobotFile, WithTheSameMarkTwiceIsRefused) {
  change("name: yellow_book", "name: red_book");
  EXPECT_NE(refusal().find("red_book"), std::string::npos);
}

TEST_F(RobotFile, TellsWhatAMarkIsAndWhatItsOutlineIs) {
  EXPECT_EQ(load().marks[0].outline, MarkOutline::kSquare);  // where nothing is said
  change("    surface: plane\n", "    surface: plane\n    outline: disc\n");
  EXPECT_EQ(load().marks[0].outline, MarkOutline::kDisc);
  change("outline: disc", "outline: other");
  EXPECT_EQ(load().marks[0].outline, MarkOutline::kOther);
  change("    surface: plane\n    outline: other\n", "    surface: ball\n");
  EXPECT_EQ(load().marks[0].surface, MarkSurface::kBall);
}

TEST_F(RobotFile, WithAnOutlineThatNoMarkHasIsRefused) {
  change("    surface: plane\n", "    surface: plane\n    outline: heart\n");
  EXPECT_NE(refusal().find("'marks[0].outline' is 'heart'; allowed: square or disc or other"), std::string::npos)
      << refusal();
}

TEST_F(RobotFile, WithAnOutlineOfWhatIsNoPlaneIsRefused) {
  change("    surface: plane\n", "    surface: ball\n    outline: square\n");
  EXPECT_NE(refusal().find("'marks[0].outline'"), std::string::npos) << refusal();
  EXPECT_NE(refusal().find("where surface is plane"), std::string::npos) << refusal();
}

// A name travels in messages and is printed.
TEST_F(RobotFile, WithANameThatCouldHarmATerminalIsRefused) {
  for (const char* name : {R"("red\e[31m")", R"("red\nbook")", R"("red\0book")", R"("red\u202Ebook")"}) {
    const std::string before = text_;
    change("name: red_book", std::string("name: ") + name);
    const std::string why = refusal();
    EXPECT_NE(why.find("'marks[1].name' is 'red\\"), std::string::npos) << why;
    EXPECT_NE(why.find("allowed: a text of at most 200 bytes of UTF-8"), std::string::npos) << why;
    text_ = before;
  }
}

TEST_F(RobotFile, WithAStopDeviceThatCouldHarmATerminalIsRefused) {
  change("stop_devices: [", "stop_devices: [\"arm\\r\", ");
  EXPECT_NE(refusal().find("'stop_devices' is 'arm\\r'"), std::string::npos) << refusal();
}

TEST_F(RobotFile, WithAHomePostureBeyondALimitIsRefused) {
  change("home_deg: [0.0, 120.0, -150.0]", "home_deg: [0.0, 170.0, -150.0]");
  EXPECT_NE(refusal().find("home_deg[1]"), std::string::npos);
}

TEST_F(RobotFile, ThatIsNotYamlIsRefused) {
  text_ = "cameras: [";
  EXPECT_NE(refusal().find("line"), std::string::npos);
}

TEST_F(RobotFile, ThatIsNotThereIsRefused) {
  try {
    load_robot_description("/nowhere/robot.yaml");
    FAIL() << "accepted";
  } catch (const ConfigurationError& error) {
    EXPECT_EQ(std::string(error.what()),
              "/nowhere/robot.yaml: cannot be opened; allowed: a readable robot description, --robot-file FILE");
  }
}

}  // namespace
}  // namespace markservo::robot
