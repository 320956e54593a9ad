#include "services/mark-detector/learning/robot_file_edit.hpp"

#include <gtest/gtest.h>

#include "common/robot/configuration_error.hpp"

namespace markservo::mark_detector {
namespace {

const robot::ColourInterval kNew{351.0, 20.0, 0.4, 1.0, 0.125, 1.0};

TEST(RobotFileEdit, ChangesSixNumbersAndNothingElse) {
  const std::string before =
      "# \xC3\xA4 comment: hue_deg: [1, 2]\n"
      "marks:\n"
      "  - name: green   # the first\n"
      "    colour: {hue_deg: [95.0, 150.0], saturation: [0.40, 1.0], value: [0.15, 1.0]}\n"
      "  - name: red\n"
      "    colour: {value: [0.20, 1.0], hue_deg: [345.0, 15.0],  saturation: [0.50, 1]}  # \xC3\xBC\n"
      "stop_devices: [arm]";
  const std::string after =
      "# \xC3\xA4 comment: hue_deg: [1, 2]\n"
      "marks:\n"
      "  - name: green   # the first\n"
      "    colour: {hue_deg: [95.0, 150.0], saturation: [0.40, 1.0], value: [0.15, 1.0]}\n"
      "  - name: red\n"
      "    colour: {value: [0.125, 1.0], hue_deg: [351.0, 20.0],  saturation: [0.4, 1.0]}  # \xC3\xBC\n"
      "stop_devices: [arm]";
  EXPECT_EQ(with_colour(before, "robot.yaml", "red", kNew), after);
}

TEST(RobotFileEdit, ReadsBlocksAndWindowsLineEnds) {
  const std::string before =
      "marks:\r\n- colour:\r\n    hue_deg:\r\n      - 1\r\n      - 2   # to\r\n    saturation: [\r\n      0.1, 0.2]\r\n"
      "    value: [0.3, 0.4]\r\n  name: 'red'\r\n";
  const std::string after =
      "marks:\r\n- colour:\r\n    hue_deg:\r\n      - 351.0\r\n      - 20.0   # to\r\n    saturation: [\r\n      0.4, "
      "1.0]\r\n    value: [0.125, 1.0]\r\n  name: 'red'\r\n";
  EXPECT_EQ(with_colour(before, "robot.yaml", "red", kNew), after);
}

TEST(RobotFileEdit, RefusesWhatItCannotChangeAlone) {
  const std::string shared =
      "marks:\n"
      "  - {name: a, colour: &same {hue_deg: [1, 2], saturation: [0, 1], value: [0, 1]}}\n"
      "  - {name: b, colour: *same}\n";
  EXPECT_THROW(with_colour(shared, "robot.yaml", "a", kNew), ConfigurationError);
  EXPECT_THROW(with_colour(shared, "robot.yaml", "b", kNew), ConfigurationError);
  EXPECT_THROW(with_colour(shared, "robot.yaml", "c", kNew), ConfigurationError);
  EXPECT_THROW(with_colour("marks: 3", "robot.yaml", "a", kNew), ConfigurationError);
  EXPECT_THROW(with_colour("marks: [", "robot.yaml", "a", kNew), ConfigurationError);
  const std::string quoted = "marks: [{name: a, colour: {hue_deg: [\"1\", 2], saturation: [0, 1], value: [0, 1]}}]";
  EXPECT_THROW(with_colour(quoted, "robot.yaml", "a", kNew), ConfigurationError);
}

}  // namespace
}  // namespace markservo::mark_detector
