#include "tests/system/fault_campaign/message_craft.hpp"

#include <markservo/BaseGoal.hpp>
#include <markservo/ServoGoal.hpp>
#include <markservo/StopRequest.hpp>
#include <markservo/TaskCommand.hpp>
#include <set>

namespace markservo::campaign {
namespace {

using reflection::Kind;

const reflection::TypeCatalog& types() {
  return reflection::TypeCatalog::ours();
}

bool ends_with(const std::string& text, const std::string& end) {
  return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

Bytes posture_goal(const Bench& bench) {
  ServoGoal goal{};
  goal.utime = world_now(bench);
  goal.goal_id = 1;
  goal.kind = ServoGoal::POSTURE;
  goal.position = bench.truth().shaft;
  goal.num_joints = static_cast<std::int32_t>(goal.position.size());
  goal.gripper_opening = 0.04;
  goal.gripper_force = 10.0;
  return encoded(goal);
}

Bytes drive_goal(const Bench& bench) {
  BaseGoal goal{};
  goal.utime = world_now(bench);
  goal.goal_id = 1;
  goal.kind = BaseGoal::DRIVE;
  goal.frame = BaseGoal::WORLD;
  goal.pose = bench.base_truth().pose;
  return encoded(goal);
}

Bytes stop_request(const Bench& bench) {
  StopRequest request{};
  request.utime = world_now(bench);
  request.request_id = 1;
  request.kind = StopRequest::STOP;
  request.source = "another operator";
  request.reason = "STOP by another operator";
  return encoded(request);
}

Bytes abort_command(const Bench& bench) {
  TaskCommand command{};
  command.utime = bench.task().utime;
  command.command_id = 1;
  command.kind = TaskCommand::ABORT;
  return encoded(command);
}

}  // namespace

std::int64_t world_now(const Bench& bench) {
  return std::max(bench.truth().utime, bench.base_truth().utime);
}

std::optional<Bytes> sample_for(Bench& bench, const std::string& channel) {
  if (channel == "STOP") return stop_request(bench);
  if (channel == "TASK_COMMAND") return abort_command(bench);
  if (const KeptMessage* last = bench.last_heard(channel)) {
    // A goal to hold moves nothing.
    const bool goal = channel == "SERVO_GOAL" || channel == "BASE_GOAL";
    if (!goal || get_integer(last->data, "kind").value_or(0) != ServoGoal::HOLD) return last->data;
  }
  if (channel == "SERVO_GOAL") return posture_goal(bench);
  if (channel == "BASE_GOAL") return drive_goal(bench);
  return std::nullopt;
}

void shift_stamps(Bytes& message, std::int64_t shift) {
  for (const LeafSpan& leaf : leaf_spans(types(), message)) {
    if (ends_with(leaf.name, "utime")) put_integer(message, leaf, integer_at(message, leaf) + shift);
  }
}

bool set_integer(Bytes& message, const std::string& name, std::int64_t value) {
  for (const LeafSpan& leaf : leaf_spans(types(), message)) {
    if (leaf.name != name || leaf.kind == Kind::kString || leaf.kind == Kind::kDouble) continue;
    put_integer(message, leaf, value);
    return true;
  }
  return false;
}

std::optional<std::int64_t> get_integer(const Bytes& message, const std::string& name) {
  for (const LeafSpan& leaf : leaf_spans(types(), message)) {
    if (leaf.name == name && leaf.kind != Kind::kString && leaf.kind != Kind::kDouble) return integer_at(message, leaf);
  }
  return std::nullopt;
}

void displace(Bytes& message, double amount) {
  constexpr double kOpen = 0.045;  // m: what hangs in the hand would fall
  static const std::set<std::string> kKept = {"gripper_force", "speed_limit", "tolerance", "clearance"};
  for (const LeafSpan& leaf : leaf_spans(types(), message)) {
    const std::string field = leaf.path.substr(0, leaf.path.find('['));
    if (leaf.kind != Kind::kDouble || kKept.count(field) > 0) continue;
    if (leaf.path.find("covariance") != std::string::npos) continue;
    const bool opening = field == "gripper_opening";
    put_real(message, leaf, opening ? kOpen : real_at(message, leaf) + amount);
  }
}

}  // namespace markservo::campaign
