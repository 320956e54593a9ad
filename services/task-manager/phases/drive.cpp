#include "services/task-manager/phases/drive.hpp"

#include <fmt/format.h>

#include "services/task-manager/guards.hpp"
#include "services/task-manager/phases/active_phase.hpp"
#include "services/task-manager/phases/endings.hpp"
#include "services/task-manager/plans/approach_plan.hpp"

namespace markservo::task_manager {
namespace {

std::string words_of(const geometry::PlanePose& pose) {
  return fmt::format("x {:.2f} m, y {:.2f} m, {:.0f} degrees", pose.x, pose.y, geometry::degrees(pose.heading));
}

}  // namespace

void Drive::begin(PhaseContext& context) {
  since_ = context.now();
  if (stage_ == Stage::kDriving) set_off(context);
}

std::optional<Transition> Drive::step(PhaseContext& context) {
  switch (stage_) {
    case Stage::kMakingReady:
      return make_ready(context);
    case Stage::kFolding:
      return fold(context);
    case Stage::kDriving:
      return watch(context);
    case Stage::kStanding:
      if (context.seconds_since(since_) < context.parameters.drive.settle_time) return std::nullopt;
      return arrived(context);
  }
  return std::nullopt;
}

std::optional<Transition> Drive::make_ready(PhaseContext& context) {
  const Input& input = context.input;
  if (!input.arm || !input.stop.known) {
    if (context.seconds_since(since_) <= context.parameters.look.timeout) return std::nullopt;
    return not_taken(context, who_is_silent(input));
  }
  const robot::JointVector off_home = input.arm->q - context.arm().home;
  if (off_home.cwiseAbs().maxCoeff() <= context.parameters.drive.home_tolerance) {
    set_off(context);
    return std::nullopt;
  }
  const PosturePath path = plan_home(context.arm(), context.parameters, {input.arm->q, input.arm->gripper_opening});
  if (!path.reachable()) return not_taken(context, "no way home: " + path.trouble());
  stage_ = Stage::kFolding;
  context.reason = "folding the arm for the drive";
  folding_ = MoveSequence(path.moves());
  folding_.begin(context);
  return std::nullopt;
}

std::optional<Transition> Drive::fold(PhaseContext& context) {
  const MoveReport report = folding_.step(context);
  if (report.state != MoveState::kDone) return not_done(report);
  set_off(context);
  return std::nullopt;
}

void Drive::set_off(PhaseContext& context) {
  stage_ = Stage::kDriving;
  words_ = (from_robot_ ? "driving on by " : "driving to ") + words_of(pose_);
  context.reason = words_;
  context.task.driven = true;
  progress_ = begin_of_drive(context.now());
  DriveGoal goal;
  goal.drive = true;
  goal.from_robot = from_robot_;
  goal.pose = pose_;
  goal.clearance = context.parameters.drive.clearance;
  goal.speed = context.parameters.drive.speed;
  context.base_goals.set(goal);
}

Transition Drive::arrived(const PhaseContext& context) {
  if (context.task.command.kind == CommandKind::kDrive) return {Done(), "arrived"};
  return look_for_target(context);
}

std::optional<Transition> Drive::watch(PhaseContext& context) {
  const DriveReport report =
      watch_drive(context.base_goals.newest().id, context.input, context.now(), context.parameters.drive, progress_);
  switch (report.state) {
    case DriveState::kUnderWay:
      context.reason = words_;
      break;
    case DriveState::kWaiting:
      context.reason = words_ + "; " + report.reason;
      break;
    case DriveState::kArrived:
      stage_ = Stage::kStanding;
      since_ = context.now();
      context.reason = "arrived";
      break;
    case DriveState::kFailed:
      return failed(report.reason);
    case DriveState::kStopped:
      return stopped(report.reason);
  }
  return std::nullopt;
}

}  // namespace markservo::task_manager
