#include "services/bus-top/field_lines.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <markservo/JointState.hpp>
#include <markservo/StereoFrame.hpp>
#include <markservo/TargetPose.hpp>
#include <markservo/TaskState.hpp>
#include "tests/unit/encoded.hpp"

namespace markservo::bus_top {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::Not;

template <class M>
std::vector<std::string> lines_of(const M& message) {
  const auto bytes = test::encoded(message);
  const auto decoded = reflection::decode(reflection::TypeCatalog::ours(), bytes.data(), bytes.size());
  EXPECT_EQ(decoded.error, "");
  return field_lines(decoded.fields);
}

TEST(FieldLines, AlignValuesBehindTheirNames) {
  JointState joints{};
  joints.utime = 5;
  joints.moving = 1;
  joints.num_joints = 2;
  joints.position = {0.25, -1.5};
  joints.speed = {0.0, 0.0};
  EXPECT_THAT(
      lines_of(joints),
      ElementsAre("utime            5", "session          0", "seq              0", "num_joints       2",
                  "position         [0.25, -1.5]", "speed            [0, 0]", "measured         false",
                  "moving           true", "gripper_opening  0", "contact_known    false", "contact          false"));
}

TEST(FieldLines, ShortenALongArrayAndSayItsLength) {
  JointState joints{};
  joints.num_joints = 7;
  joints.position = {1, 2, 3, 4, 5, 6, 7};
  joints.speed.assign(7, 0.0);
  EXPECT_THAT(lines_of(joints), Contains("position         [1, 2, 3, 4, 5, 6, ... 7 in all]"));
}

TEST(FieldLines, IndentWhatIsNestedAndCountWhatIsLeftOut) {
  LocatedMark mark{};
  mark.name = "red_book";
  mark.p_C.x = 0.125;
  TargetPose pose{};
  pose.marks.assign(10, mark);
  pose.num_marks = 10;
  const auto lines = lines_of(pose);
  EXPECT_THAT(lines, Contains("marks[0]"));
  EXPECT_THAT(lines, Contains("  name          \"red_book\""));
  EXPECT_THAT(lines, Contains("  p_C"));
  EXPECT_THAT(lines, Contains("    x  0.125"));
  EXPECT_THAT(lines, Contains("marks[7]"));
  EXPECT_THAT(lines, Not(Contains("marks[8]")));
  EXPECT_THAT(lines, Contains("marks: 2 more"));
}

TEST(FieldLines, NameStates) {
  TaskState state{};
  state.state = TaskState::HOLD_LIFTED;
  EXPECT_THAT(lines_of(state), Contains(::testing::MatchesRegex("state +HOLD_LIFTED")));
}

TEST(FieldLines, TellAnImageByItsSize) {
  StereoFrame frame{};
  frame.left.assign(614400, 0);
  frame.left_size = 614400;
  EXPECT_THAT(lines_of(frame), Contains("left         614 kB"));
}

TEST(FieldLines, LetNoTextSpeakToTheTerminal) {
  TaskState state{};
  state.reason = "a\033[2Jb\n";
  for (const std::string& line : lines_of(state)) EXPECT_EQ(line.find_first_of("\033\n"), std::string::npos) << line;
}

}  // namespace
}  // namespace markservo::bus_top
