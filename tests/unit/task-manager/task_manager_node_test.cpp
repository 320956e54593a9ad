// The node on an in-process bus: one TASK_STATE per SERVO_STATUS, goals, bad input.

#include "services/task-manager/task_manager_node.hpp"

#include <gtest/gtest.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdint>
#include <markservo/BaseGoal.hpp>
#include <markservo/BaseStatus.hpp>
#include <markservo/JointState.hpp>
#include <markservo/LocatedMark.hpp>
#include <markservo/ServiceStatus.hpp>
#include <markservo/ServoGoal.hpp>
#include <markservo/ServoStatus.hpp>
#include <markservo/StopState.hpp>
#include <markservo/TargetPose.hpp>
#include <markservo/TaskCommand.hpp>
#include <markservo/TaskState.hpp>
#include <vector>

#include "common/robot/configuration_error.hpp"
#include "tests/unit/bus/node_on_a_bus.hpp"

namespace markservo::task_manager {
namespace {

constexpr std::int64_t kFrame_us = 33'333;

class TaskManagerOnABus : public bus::NodeOnABus<TaskManagerNode> {
 protected:
  TaskManagerOnABus() : NodeOnABus("task-manager") {
    start_node();
    collect(channels::kTaskState, states_);
    collect(channels::kServoGoal, goals_);
    collect(channels::kBaseGoal, base_goals_);
  }

  void tell_stop(bool latched, const std::string& device = "arm") {
    StopState stop = bus::stop_state(utime_, device, latched);
    stops_.publish(stop);
  }

  void tell_joints(int num_joints = 3) {
    JointState joints{};
    joints.utime = utime_;
    joints.num_joints = num_joints;
    joints.position = {0.0, 2.0944, -2.6180};
    joints.position.resize(static_cast<std::size_t>(num_joints));
    joints.speed.assign(static_cast<std::size_t>(num_joints), 0.0);
    joints.gripper_opening = 0.05;
    joints_.publish(joints);
  }

  void start(const std::string& target, std::int64_t id = 1) {
    TaskCommand command{};
    command.utime = utime_;
    command.session = 99;
    command.command_id = id;
    command.kind = TaskCommand::START;
    command.target = target;
    commands_.publish(command);
  }

  void start_drive() {
    TaskCommand command{};
    command.utime = utime_;
    command.session = 99;
    command.command_id = 1;
    command.kind = TaskCommand::START;
    command.target = "red_book";
    command.drive = 1;
    command.drive_pose.x = 0.2;
    command.drive_pose.y = 1.05;
    command.drive_pose.heading = 1.5;
    commands_.publish(command);
  }

  // base-navigator's word on the newest goal.
  void tell_base(std::int8_t state, std::int64_t session) {
    BaseStatus status{};
    status.utime = utime_;
    status.goal_session = session;
    status.goal_id = base_goals_.back().goal_id;
    status.state = state;
    status.reason = "test";
    base_statuses_.publish(status);
  }

  // The target located at `y`, and visual-servo's word on this frame.
  void frame(double y = 0.25, std::int8_t servo_state = ServoStatus::HOLD) {
    utime_ += kFrame_us;
    ++frame_seq_;
    for (const std::string& device : others_) tell_stop(false, device);
    TargetPose pose{};
    pose.utime = pose.frame_utime = utime_;
    LocatedMark mark{};
    mark.name = "red_book";
    mark.p_C.x = 0.0325;
    mark.p_C.y = y;
    mark.p_C.z = 0.032;
    pose.num_marks = 1;
    pose.marks.push_back(mark);
    poses_.publish(pose);
    ServoStatus status{};
    status.utime = status.frame_utime = utime_;
    status.frame_session = 5;
    status.frame_seq = frame_seq_;
    status.state = servo_state;
    tell(statuses_, status);
  }

  static std::vector<std::string> stop_devices_but_the_arm() {
    auto devices = robot::load_robot_description(bus::kRobotFile).stop_devices;
    devices.erase(std::remove(devices.begin(), devices.end(), "arm"), devices.end());
    return devices;
  }

  const std::vector<std::string> others_ = stop_devices_but_the_arm();  // they always speak
  bus::Publisher<TaskCommand> commands_ = bus_.advertise(channels::kTaskCommand);
  bus::Publisher<StopState> stops_ = bus_.advertise(channels::kStopState);
  bus::Publisher<JointState> joints_ = bus_.advertise(channels::kJointState);
  bus::Publisher<TargetPose> poses_ = bus_.advertise(channels::kTargetPose);
  bus::Publisher<ServoStatus> statuses_ = bus_.advertise(channels::kServoStatus);
  bus::Publisher<BaseStatus> base_statuses_ = bus_.advertise(channels::kBaseStatus);
  std::vector<TaskState> states_;
  std::vector<ServoGoal> goals_;
  std::vector<BaseGoal> base_goals_;
  std::int64_t utime_ = 1'000'000'000;
  std::int64_t frame_seq_ = 0;
};

TEST_F(TaskManagerOnABus, AnswersEachServoStatusWithOneTaskStateOfTheSameFrame) {
  for (int i = 0; i < 10; ++i) frame();
  ASSERT_EQ(states_.size(), 10u);
  EXPECT_EQ(states_.back().frame_session, 5);
  EXPECT_EQ(states_.back().frame_seq, frame_seq_);
  EXPECT_EQ(states_.back().frame_utime, utime_);
  EXPECT_EQ(states_.back().utime, utime_);
  EXPECT_EQ(states_.back().state, TaskState::IDLE);
  EXPECT_EQ(states_.back().reason, "started: no task");
}

TEST_F(TaskManagerOnABus, SendsNoGoalBeforeItKnowsTheArmAndHoldsThen) {
  frame();
  EXPECT_TRUE(goals_.empty());
  tell_joints();
  frame();
  EXPECT_TRUE(goals_.empty()) << "whose report it is may be anyone's before a STOP_STATE";
  tell_stop(false);
  tell_stop(false, "base");
  frame();
  ASSERT_EQ(goals_.size(), 1u);
  EXPECT_EQ(goals_[0].kind, ServoGoal::HOLD);
  EXPECT_EQ(goals_[0].session, bus_.session());
  EXPECT_EQ(goals_[0].utime, utime_);
}

TEST_F(TaskManagerOnABus, AStartMovesTheHandTowardsTheTarget) {
  tell_joints();
  tell_stop(false);
  start("red_book");
  for (int i = 0; i < 12; ++i) frame();
  EXPECT_EQ(states_.back().state, TaskState::APPROACH);
  EXPECT_EQ(states_.back().command_session, 99);
  EXPECT_EQ(states_.back().command_id, 1);
  EXPECT_EQ(states_.back().target, "red_book");
  EXPECT_GT(goals_.back().goal_id, 1);
}

TEST_F(TaskManagerOnABus, AStopDeviceThatFallsSilentStopsTheTask) {
  tell_joints();
  tell_stop(false);
  start("red_book");
  for (int i = 0; i < 28; ++i) frame();
  EXPECT_EQ(states_.back().state, TaskState::APPROACH);
  for (int i = 0; i < 4; ++i) frame();
  EXPECT_EQ(states_.back().state, TaskState::STOPPED);
  EXPECT_EQ(states_.back().reason, "a stop device is silent: no STOP_STATE of arm");
}

TEST_F(TaskManagerOnABus, AStopThatIsResetBeforeTheNextStatusIsNotMissed) {
  tell_joints();
  tell_stop(false);
  start("red_book");
  for (int i = 0; i < 12; ++i) frame();
  ASSERT_EQ(states_.back().state, TaskState::APPROACH);
  tell_stop(true);
  tell_stop(false);
  frame();
  EXPECT_EQ(states_.back().state, TaskState::STOPPED);
}

TEST_F(TaskManagerOnABus, ALatchedDeviceRefuses) {
  tell_joints();
  tell_stop(true);
  start("red_book");
  frame();
  EXPECT_EQ(states_.back().state, TaskState::REFUSED);
  EXPECT_EQ(states_.back().result, TaskState::RESULT_REFUSED);
  EXPECT_EQ(states_.back().reason, "stop is latched: reset it first (arm: test)");
}

TEST_F(TaskManagerOnABus, PassesOnWhereTheCallerBelievesTheTarget) {
  tell_joints();
  tell_stop(false);
  TaskCommand command{};
  command.utime = utime_;
  command.session = 99;
  command.command_id = 1;
  command.target = "blue_book";  // in no TARGET_POSE
  command.expected_known = 1;
  command.p_CT_expected.y = 0.6;
  commands_.publish(command);
  for (int i = 0; i < 40; ++i) frame();
  EXPECT_EQ(states_.back().state, TaskState::REFUSED);
  EXPECT_EQ(states_.back().reason.rfind("unreachable: beyond the arm's reach: 0.", 0), 0U) << states_.back().reason;
}

TEST_F(TaskManagerOnABus, HoldsTheBaseFromItsFirstStepOnFiveTimesASecond) {
  for (int i = 0; i < 30; ++i) frame();
  EXPECT_NEAR(static_cast<double>(base_goals_.size()), 5.0, 1.0);
  EXPECT_EQ(base_goals_.front().kind, BaseGoal::HOLD);
  EXPECT_EQ(base_goals_.front().session, bus_.session());
  EXPECT_EQ(base_goals_.back().goal_id, base_goals_.front().goal_id);
  EXPECT_EQ(base_goals_.back().utime % kFrame_us, utime_ % kFrame_us);
}

TEST_F(TaskManagerOnABus, ADriveGoesToTheCommandedPoseAndIsWatched) {
  tell_joints();
  tell_stop(false);
  start_drive();
  frame();
  frame();
  EXPECT_EQ(states_.back().state, TaskState::DRIVE);
  ASSERT_EQ(base_goals_.back().kind, BaseGoal::DRIVE);
  EXPECT_EQ(base_goals_.back().frame, BaseGoal::WORLD);
  EXPECT_EQ(base_goals_.back().pose.x, 0.2);
  EXPECT_EQ(base_goals_.back().pose.y, 1.05);
  EXPECT_EQ(base_goals_.back().pose.heading, 1.5);
  EXPECT_GT(base_goals_.back().clearance, 0.0);
  EXPECT_GT(base_goals_.back().speed, 0.0);
  tell_base(BaseStatus::ARRIVED, bus_.session());
  for (int i = 0; i < 17; ++i) {
    frame();
    if (i % 6 == 0) tell_stop(false);
  }
  EXPECT_EQ(states_.back().state, TaskState::LOOK);
  EXPECT_EQ(base_goals_.back().kind, BaseGoal::HOLD);
}

TEST_F(TaskManagerOnABus, AnArrivalAtAnotherOnesGoalIsNone) {
  tell_joints();
  tell_stop(false);
  start_drive();
  frame();
  tell_base(BaseStatus::ARRIVED, bus_.session() + 1);
  for (int i = 0; i < 10; ++i) frame();
  EXPECT_EQ(base_goals_.back().kind, BaseGoal::DRIVE);
}

TEST_F(TaskManagerOnABus, IgnoresWhatCannotBe) {
  tell_joints();
  tell_joints(2);  // another arm's
  EXPECT_THROW(frame(0.25, static_cast<std::int8_t>(77)), std::invalid_argument)
      << "no bus carries a state that is none";
  EXPECT_TRUE(states_.empty());
  frame();
  EXPECT_EQ(states_.size(), 1u);
  std::int64_t refused = 0;
  for (const auto& channel : bus_.status().channels) refused += channel.refused;
  EXPECT_EQ(refused, 1);
}

TEST(TaskManagerOptions, RangeOfThePlaceMustNotBeEmpty) {
  TaskManagerNode node;
  CLI::App app;
  node.add_options(app);
  app.parse("--place-radius-min 0.3 --place-radius-max 0.2");
  try {
    node.configure(bus::kRobotFile);
    FAIL() << "accepted";
  } catch (const ConfigurationError& error) {
    EXPECT_NE(std::string(error.what()).find("place-radius-max is 0.2"), std::string::npos) << error.what();
  }
}

TEST(TaskManagerOptions, DevicesAreTheRobots) {
  for (const char* option : {"--arm-device", "--base-device"}) {
    TaskManagerNode node;
    CLI::App app;
    node.add_options(app);
    app.parse(std::string(option) + " amr");
    try {
      node.configure(bus::kRobotFile);
      FAIL() << "accepted";
    } catch (const ConfigurationError& error) {
      EXPECT_NE(std::string(error.what()).find(std::string(option) + " 'amr': allowed: stop_devices of"),
                std::string::npos)
          << error.what();
    }
  }
}

}  // namespace
}  // namespace markservo::task_manager
