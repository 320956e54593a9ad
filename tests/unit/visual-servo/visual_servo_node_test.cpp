// visual-servo on a bus: one command and one status per TARGET_POSE, in reply to messages in any order.

#include "services/visual-servo/visual_servo_node.hpp"

#include <gtest/gtest.h>

#include <CLI/CLI.hpp>
#include <markservo/JointCommand.hpp>
#include <markservo/JointState.hpp>
#include <markservo/ServiceStatus.hpp>
#include <markservo/ServoGoal.hpp>
#include <markservo/ServoStatus.hpp>
#include <markservo/StopState.hpp>
#include <markservo/TargetPose.hpp>
#include <vector>

#include "common/robot/configuration_error.hpp"
#include "tests/unit/bus/node_on_a_bus.hpp"

namespace markservo::visual_servo {
namespace {

class VisualServoOnABus : public bus::NodeOnABus<VisualServoNode> {
 protected:
  VisualServoOnABus() : NodeOnABus("visual-servo") {
    start_node();
    collect(channels::kJointCommand, commands_);
    collect(channels::kServoStatus, statuses_);
  }

  void tell_stop(bool latched, const std::string& device = "arm") {
    tell(stops_, bus::stop_state(utime_, device, latched));
  }

  void tell_joints(int num_joints = 3) {
    JointState joints{};
    joints.utime = utime_;
    joints.num_joints = num_joints;
    joints.position.assign(static_cast<std::size_t>(num_joints), 0.0);
    if (num_joints == 3) joints.position = {0.0, 2.0944, -2.6180};
    joints.speed.assign(static_cast<std::size_t>(num_joints), 0.0);
    joints.gripper_opening = 0.05;
    tell(joints_, joints);
  }

  void tell_posture_goal() {
    ServoGoal goal{};
    goal.utime = utime_;
    goal.goal_id = 3;
    goal.kind = ServoGoal::POSTURE;
    goal.num_joints = 3;
    goal.position = {0.5, 2.0, -2.5};
    goal.gripper_opening = 0.05;
    tell(goals_, goal);
  }

  void tell_pose() {
    TargetPose pose{};
    pose.utime = pose.frame_utime = utime_;
    pose.frame_session = 4;
    pose.frame_seq = ++frame_seq_;
    tell(poses_, pose);
  }

  void frame() {
    utime_ += 33'333;
    tell_joints();
    tell_pose();
  }

  bus::Publisher<StopState> stops_ = bus_.advertise(channels::kStopState);
  bus::Publisher<JointState> joints_ = bus_.advertise(channels::kJointState);
  bus::Publisher<ServoGoal> goals_ = bus_.advertise(channels::kServoGoal);
  bus::Publisher<TargetPose> poses_ = bus_.advertise(channels::kTargetPose);
  std::int64_t utime_ = 1'700'000'000'000'000;
  std::int64_t frame_seq_ = 0;
  std::vector<JointCommand> commands_;
  std::vector<ServoStatus> statuses_;
};

TEST_F(VisualServoOnABus, AnswersEachPoseWithOneCommandAndOneStatusOfItsFrame) {
  tell_stop(false);
  for (int i = 0; i < 5; ++i) frame();
  ASSERT_EQ(commands_.size(), 5U);
  ASSERT_EQ(statuses_.size(), 5U);
  EXPECT_EQ(commands_.back().frame_seq, 5);
  EXPECT_EQ(commands_.back().frame_session, 4);
  EXPECT_EQ(commands_.back().utime, utime_);
  EXPECT_EQ(statuses_.back().frame_utime, utime_);
  EXPECT_EQ(statuses_.back().state, ServoStatus::HOLD);
}

TEST_F(VisualServoOnABus, SaysStaleAndCommandsNothingBeforeTheFirstJointState) {
  tell_stop(false);
  tell_pose();
  EXPECT_TRUE(commands_.empty());
  ASSERT_EQ(statuses_.size(), 1U);
  EXPECT_EQ(statuses_.back().state, ServoStatus::STALE);
}

TEST_F(VisualServoOnABus, MovesForAGoalAndEchoesIt) {
  tell_stop(false);
  tell_posture_goal();
  for (int i = 0; i < 5; ++i) frame();
  EXPECT_EQ(statuses_.back().state, ServoStatus::POSTURE);
  EXPECT_EQ(statuses_.back().goal_id, 3);
  EXPECT_EQ(statuses_.back().goal_session, goals_.session());
  EXPECT_GT(commands_.back().position[0], commands_.front().position[0]);
  for (const double speed : commands_.back().speed_limit) EXPECT_GT(speed, 0.0);
}

TEST_F(VisualServoOnABus, OnlyTheArmsStopStateCounts) {
  tell_stop(false);
  tell_stop(true, "base");
  tell_posture_goal();
  frame();
  EXPECT_EQ(statuses_.back().state, ServoStatus::POSTURE);
  tell_stop(true);
  frame();
  EXPECT_EQ(statuses_.back().state, ServoStatus::STOPPED);
  EXPECT_EQ(statuses_.back().goal_id, 0);
}

TEST_F(VisualServoOnABus, RefusesJointStatesOfAnotherArm) {
  tell_stop(false);
  tell_joints(5);
  tell_pose();
  EXPECT_TRUE(commands_.empty());
  for (const auto& channel : bus_.status().channels) {
    EXPECT_EQ(channel.refused, channel.channel == "JOINT_STATE" ? 1 : 0) << channel.channel;
  }
}

TEST(VisualServoConfiguration, AStopDeviceThatTheRobotDoesNotHaveIsRefused) {
  CLI::App app;
  VisualServoNode node;
  node.add_options(app);
  app.parse("--stop-device wing", false);
  try {
    node.configure(bus::kRobotFile);
    FAIL();
  } catch (const ConfigurationError& error) {
    EXPECT_NE(std::string(error.what()).find("'wing'"), std::string::npos);
    EXPECT_NE(std::string(error.what()).find("arm"), std::string::npos);
  }
}

}  // namespace
}  // namespace markservo::visual_servo
