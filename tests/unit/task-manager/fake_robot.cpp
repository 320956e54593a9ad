#include "tests/unit/task-manager/fake_robot.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "common/robot/arm_kinematics.hpp"
#include "common/robot/workspace.hpp"
#include "common/task/transitions.hpp"
#include "services/task-manager/plans/approach_plan.hpp"

namespace markservo::task_manager {
namespace {

constexpr double kJointStep = 0.05;    // rad a frame
constexpr double kServoStep = 0.004;   // m a frame
constexpr double kFingerStep = 0.002;  // m a frame
constexpr double kBaseStep = 0.013;    // m a frame: 0.4 m/s

}  // namespace

robot::RobotDescription default_robot() {
  return robot::load_robot_description(MARKSERVO_SOURCE_DIR "/config/robot.yaml");
}

FakeRobot::FakeRobot() : FakeRobot(default_robot()) {}

FakeRobot::FakeRobot(const robot::RobotDescription& description, const Parameters& parameters)
    : robot_(description), procedure_(description, parameters) {
  q_ = robot_.arm ? robot_.arm->home : robot::JointVector::Zero();
  start_ = p_CT;
}

void FakeRobot::send(CommandKind kind, const std::string& target, bool carry) {
  command_ = Command{};
  command_.session = 42;
  command_.id = next_command_++;
  command_.kind = kind;
  command_.target = target;
  command_.carry = carry;
  if (kind == CommandKind::kStart && !attached_) start_ = p_CT;
  send_again();
}

void FakeRobot::send_drive(const geometry::PlanePose& pose, const std::string& target) {
  send(CommandKind::kStart, target);
  commands_.back().drive_pose = command_.drive_pose = pose;
}

void FakeRobot::send_drive_only(const geometry::PlanePose& pose) {
  send(CommandKind::kDrive);
  commands_.back().drive_pose = command_.drive_pose = pose;
}

void FakeRobot::send_again(CommandKind kind) {
  command_.kind = kind;
  send_again();
}

void FakeRobot::send_again() {
  command_.utime = utime_;
  commands_.push_back(command_);
}

Eigen::Vector3d FakeRobot::grip_point() const {
  return robot::grip_point(*robot_.arm, q_);
}

bool FakeRobot::in_view(const Eigen::Isometry3d& X_CM, double size) const {
  return robot::view_margin_px(robot_.cameras, X_CM, size) >= 0.0;
}

ServoReport FakeRobot::report() {
  ServoReport report;
  report.goal_id = follows_goals ? std::max(goal_.id, forged_goal_id) : 0;
  if (stale || frames_of_old_goals_ > 0) {
    report.state = ServoState::kStale;
    report.reason = stale ? "TARGET_POSE is 1.0 s old" : "SERVO_GOAL is old";
  } else if (stop.latched) {
    report.state = ServoState::kStopped;
  } else if (forged_goal_id > goal_.id) {
    report.state = ServoState::kPosture;
  } else if (goal_.kind == GoalKind::kHold) {
    report.settled = true;
  } else if (goal_.kind == GoalKind::kPosture) {
    report.state = ServoState::kPosture;
    report.settled = (goal_.q - q_).norm() < 1e-9;
  } else if (!unreachable.empty()) {
    report.state = ServoState::kUnreachable;
    report.reason = unreachable;
  } else if (target_sight != Sight::kLocated || hand_sight != Sight::kLocated) {
    report.state = ServoState::kLost;
  } else {
    report.settled = error_.norm() <= goal_.tolerance;
    report.state = report.settled ? ServoState::kConverged : ServoState::kServo;
  }
  return report;
}

// The base slides: what is seen of the book moves the other way.
void FakeRobot::move_base() {
  if (!drive_goal_.drive || base_stuck || stop.latched || !base_answers || frames_of_old_goals_ > 0) return;
  Eigen::Vector2d way_W(base_goal_.x - base_pose.x, base_goal_.y - base_pose.y);
  way_W *= std::min(1.0, kBaseStep / std::max(1e-12, way_W.norm()));
  if (way_W.norm() == 0.0) return;
  base_pose.x += way_W.x();
  base_pose.y += way_W.y();
  way_of_base_ += way_W.norm();
  const Eigen::Vector2d way_R = Eigen::Rotation2Dd(-base_pose.heading) * way_W;
  p_CT += Eigen::Vector3d(way_R.y(), -way_R.x(), 0.0);
  if ((q_ - robot_.arm->home).cwiseAbs().maxCoeff() > 0.05) reckless_ = "the arm was not folded";
  if (last_.phase != Phase::kDrive) reckless_ = std::string("it drove in ") + name_of(last_.phase);
}

std::optional<BaseReport> FakeRobot::base_report() const {
  if (!robot_.base) return std::nullopt;
  if (!base_answers) return base_said_;
  BaseReport report;
  report.utime = utime_ - period_us / 2;
  report.goal_id = drive_goal_.id;
  if (frames_of_old_goals_ > 0) {
    report.state = BaseState::kStale;
    report.reason = "BASE_GOAL is old";
  } else if (drive_goal_.drive) {
    const bool there = std::hypot(base_goal_.x - base_pose.x, base_goal_.y - base_pose.y) < 1e-9;
    report.state = base_stuck ? *base_stuck : there ? BaseState::kArrived : BaseState::kDriving;
    report.reason = base_reason;
  }
  return report;
}

void FakeRobot::move_arm() {
  if (stop.latched || stale || !follows_goals || forged_goal_id > goal_.id || frames_of_old_goals_ > 0) return;
  const robot::JointVector before = q_;
  if (goal_.kind == GoalKind::kPosture) {
    const robot::JointVector to_go = goal_.q - q_;
    q_ += to_go * std::min(1.0, kJointStep / std::max(1e-12, to_go.cwiseAbs().maxCoeff()));
  } else if (goal_.kind == GoalKind::kServo && report().state == ServoState::kServo) {
    Eigen::Vector3d to_go = p_CT + goal_.p_TG - grip_point();
    to_go *= std::min(1.0, kServoStep / std::max(1e-12, to_go.norm()));
    const auto ik = robot::inverse_kinematics(*robot_.arm, grip_point() + to_go, 0.0);
    if (ik.status == robot::ReachStatus::kReachable) q_ = ik.q;
  }
  if (goal_.kind == GoalKind::kServo) error_ = grip_point() - (p_CT + goal_.p_TG);
  way_ += (q_ - before).norm();
}

void FakeRobot::move_gripper() {
  if (goal_.id == 0 || stop.latched || stop.meanwhile) return;
  const auto& grip = *robot_.find_mark("red_book")->grip;
  const double width = grip.object_width;
  const bool around = (grip_point() - (p_CT + grip.p_TG)).norm() < 0.004;
  double wanted = opening_ + std::clamp(goal_.opening - opening_, -kFingerStep, kFingerStep);
  if (wanted > width) {
    attached_ = slipped_ = false;
  } else if (around && wanted < width && !attached_ && !slipped_) {
    if (slips > 0) {
      --slips;
      slipped_ = true;
    } else {
      attached_ = true;
      p_GT_ = robot::grip_pose(*robot_.arm, q_).inverse() * p_CT;
    }
  }
  if (attached_) wanted = width;
  opening_ = wanted;
  if (attached_) p_CT = robot::grip_pose(*robot_.arm, q_) * p_GT_;
}

void FakeRobot::look_for_trespass() {
  if (attached_) return;
  const auto& grip = *robot_.find_mark("red_book")->grip;
  const Eigen::Vector3d off = grip_point() - (p_CT + grip.p_TG);
  const double tip = grip_point().y() + robot_.arm->gripper.finger_beyond_grip_point;
  const bool beside_the_shelf = std::abs(q_[0]) > 0.8;
  if (tip < p_CT.y() || beside_the_shelf) return;
  if (std::abs(off.x()) > 0.002 || std::abs(off.z()) > 0.016) {
    trespass_ = "fingers " + std::to_string(off.x()) + " m beside and " + std::to_string(off.z()) + " m above";
  }
}

Output FakeRobot::frame() {
  utime_ += period_us;
  if (robot_.arm) {
    move_base();
    move_arm();
    move_gripper();
    look_for_trespass();
  }
  Input input;
  input.utime = input.now = utime_;
  input.servo = report();
  input.pose_utime = utime_;
  MarkReport target{"red_book", target_sight, p_CT};
  Eigen::Isometry3d X_CT = Eigen::Isometry3d::Identity();
  X_CT.translation() = p_CT;
  if (target.sight == Sight::kLocated && !in_view(X_CT, 0.025)) target.sight = Sight::kClipped;
  input.marks.push_back(target);
  if (robot_.arm) {
    MarkReport hand{"hand", hand_sight, robot::hand_mark(*robot_.arm, q_)};
    if (hand.sight == Sight::kLocated && !in_view(robot::hand_mark_pose(*robot_.arm, q_), 0.020)) {
      hand.sight = Sight::kUnseen;
    }
    input.marks.push_back(hand);
  }
  if (arm_answers) input.arm = ArmReport{arm_session, q_, opening_};
  input.base = base_said_ = base_report();
  input.stop = stop;
  input.commands.swap(commands_);

  last_ = procedure_.step(input, state_);
  if (last_.goal) {
    goal_ = *last_.goal;
    ++goals_sent_;
    // What is to be judged is the new goal, not the old one's end.
    if (goal_.kind == GoalKind::kServo && robot_.arm) error_ = grip_point() - (p_CT + goal_.p_TG);
  }
  if (last_.drive_goal) {
    if (last_.drive_goal->id != drive_goal_.id) {
      base_goal_ = last_.drive_goal->pose;
      if (last_.drive_goal->from_robot) {
        const Eigen::Vector2d way_W =
            Eigen::Rotation2Dd(base_pose.heading) * Eigen::Vector2d(base_goal_.x, base_goal_.y);
        base_goal_ = {base_pose.x + way_W.x(), base_pose.y + way_W.y(), base_pose.heading + base_goal_.heading};
      } else {
        base_goal_.y -= base_drift;
      }
    }
    drive_goal_ = *last_.drive_goal;
    ++drive_goals_sent_;
  }
  note(last_.phase);
  if (frames_of_old_goals_ > 0) --frames_of_old_goals_;
  return last_;
}

void FakeRobot::note(Phase phase) {
  if (!phases_.empty() && phases_.back() == phase) return;
  if (!phases_.empty()) {
    EXPECT_TRUE(may_follow(phases_.back(), phase))
        << name_of(phases_.back()) << " to " << name_of(phase) << ": " << last_.reason;
  }
  phases_.push_back(phase);
}

void FakeRobot::blind_for(double seconds) {
  utime_ += static_cast<std::int64_t>(1e6 * seconds);
  frames_of_old_goals_ = 3;
}

bool FakeRobot::run_until(Phase phase, double seconds) {
  for (const double end = this->seconds() + seconds; this->seconds() < end;) {
    if (frame().phase == phase) return true;
  }
  return false;
}

void FakeRobot::run_for(double seconds) {
  for (const double end = this->seconds() + seconds; this->seconds() < end;) frame();
}

void FakeRobot::reset_world() {
  q_ = robot_.arm->home;
  opening_ = robot_.arm->gripper.opening_max;
  attached_ = slipped_ = false;
  p_CT = start_;
}

void FakeRobot::restart_task_manager() {
  state_ = State();
  phases_.clear();
}

}  // namespace markservo::task_manager
