#pragma once

// A simulated arm with ideal servos before a servo core, frame by frame.

#include <gtest/gtest.h>

#include "common/robot/arm_kinematics.hpp"
#include "tests/unit/visual-servo/arm_simulator.hpp"
#include "tests/unit/visual-servo/test_robot.hpp"

namespace markservo::visual_servo::test {

class Rig : public testing::Test {
 protected:
  Rig() {
    arm_.place(start_, p_CT_);
    machine_.observe_stop(false, "", state_);
  }

  Goal servo_goal(std::int64_t id = 1) const {
    return grip_goal(state_.joints.empty() ? arm_.utime() : state_.joints.newest().utime, id);
  }

  Goal posture_goal(const JointVector& q, std::int64_t id = 1) const {
    Goal goal = servo_goal(id);
    goal.kind = GoalKind::kPosture;
    goal.position = {q[0], q[1], q[2]};
    return goal;
  }

  void repeat_goal(std::int64_t utime) { test::repeat_goal(machine_, state_, utime); }

  // The arm stops, and its STOP_STATE says so.
  void stop(bool latched) {
    arm_.stopped = latched;
    machine_.observe_stop(latched, "", state_);
  }

  // One frame; the arm obeys.
  Output frame() {
    PoseSample pose = arm_.expose();
    for (MarkSample& mark : pose.marks) {
      if (mark.name == "hand") mark.p_C += hand_off_;
    }
    for (JointSample sample : arm_.take_joint_states()) {
      sample.position += joints_off_;
      if (frozen_joint_ >= 0) sample.position[frozen_joint_] = frozen_at_;
      machine_.observe(sample, state_);
    }
    if (sender_lives_ && state_.followed.goal()) repeat_goal(pose.utime);
    last_pose_ = pose;
    Output output = machine_.step(pose, state_);
    arm_.finish_frame(output.command);
    return output;
  }

  Output frames(int count) {
    Output output;
    for (int i = 0; i < count; ++i) output = frame();
    return output;
  }

  // Frames until the state is reached; the frame limit fails the test.
  Output frames_until(ServoState wanted, int at_most = 100) {
    for (int i = 0; i < at_most; ++i) {
      Output output = frame();
      if (output.status.state == wanted) return output;
    }
    ADD_FAILURE() << "state not reached";
    return {};
  }

  robot::RobotDescription robot_ = the_robot();
  ServoStateMachine machine_{robot_, Parameters()};
  State state_;
  Eigen::Vector3d p_CT_{0.0325, 0.25, 0.032};
  Eigen::Vector3d goal_point_ = p_CT_ + kGripFromTarget;
  JointVector start_ = robot::inverse_kinematics(*robot_.arm, goal_point_ - Eigen::Vector3d(0.0, 0.12, 0.0), 0.0).q;
  ArmSimulator arm_{robot_, SimulatorSettings(), 3};
  PoseSample last_pose_;
  int frozen_joint_ = -1;  // its sensor lies: JOINT_STATE tells frozen_at_ (rad) of it; -1: none
  double frozen_at_ = 0.0;
  JointVector joints_off_ = JointVector::Zero();        // rad: JOINT_STATE tells so much more than is so
  Eigen::Vector3d hand_off_ = Eigen::Vector3d::Zero();  // m: the hand's mark is seen so far from where it is
  bool sender_lives_ = true;                            // the goal is repeated with every frame
};

}  // namespace markservo::visual_servo::test
