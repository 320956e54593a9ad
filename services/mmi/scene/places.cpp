#include "services/mmi/scene/places.hpp"

#include <algorithm>
#include <string>

#include "services/mmi/scene/camera_pose.hpp"
#include "services/mmi/scene/mark_words.hpp"
#include "services/mmi/scene/state_names.hpp"
#include "services/mmi/scene/vector_json.hpp"

namespace markservo::mmi {
namespace {

nlohmann::ordered_json upper_triangle(const Eigen::Matrix3d& covariance) {
  return {covariance(0, 0), covariance(0, 1), covariance(0, 2), covariance(1, 1), covariance(1, 2), covariance(2, 2)};
}

template <class State>
std::string name_in(const std::vector<std::string>& names, State state) {
  return names.at(static_cast<std::size_t>(state));
}

}  // namespace

Places::Places(const robot::RobotDescription& robot) : X_RC_(camera_pose(robot.cameras)) {}

void Places::observe(const Report& report) {
  if (const auto* targets = std::get_if<TargetReport>(&report)) {
    targets_ = *targets;
    ++version_;
  } else if (const auto* goal = std::get_if<ServoGoalReport>(&report)) {
    goal_ = *goal;
    ++version_;
  }
}

std::optional<Eigen::Vector3d> Places::grip_goal() const {
  if (!targets_ || !goal_ || !goal_->by_sight) return std::nullopt;
  const auto target = std::find_if(targets_->marks.begin(), targets_->marks.end(), [&](const MarkReport& mark) {
    return mark.name == goal_->target && mark.status == MarkStatus::kLocated;
  });
  if (target == targets_->marks.end()) return std::nullopt;
  return X_RC_ * (target->p_C + goal_->p_TG_C);
}

nlohmann::ordered_json Places::mark_json(const MarkReport& mark) const {
  static const std::vector<std::string> kStatuses = state_names("LocatedMark", "status");
  static const std::vector<std::string> kCues = state_names("LocatedMark", "cue");
  nlohmann::ordered_json json = {{"name", mark.name},
                                 {"role", word_of(mark.role)},
                                 {"status", name_in(kStatuses, mark.status)},
                                 {"cue", name_in(kCues, mark.cue)},
                                 {"p_R", nullptr},
                                 {"covariance_R", nullptr},
                                 {"normal_R", nullptr}};
  if (mark.status != MarkStatus::kLocated) return json;
  const Eigen::Matrix3d R_RC = X_RC_.linear();
  json["p_R"] = vector_json(X_RC_ * mark.p_C);
  json["covariance_R"] = upper_triangle(R_RC * mark.covariance_C * R_RC.transpose());
  if (!mark.normal_C.isZero()) json["normal_R"] = vector_json(R_RC * mark.normal_C);
  return json;
}

nlohmann::ordered_json Places::json() const {
  if (!targets_) return nullptr;
  auto marks = nlohmann::ordered_json::array();
  for (const MarkReport& mark : targets_->marks) marks.push_back(mark_json(mark));
  const std::optional<Eigen::Vector3d> goal = grip_goal();
  return {{"utime", std::to_string(targets_->utime)},
          {"frame_seq", std::to_string(targets_->frame_seq)},
          {"marks", std::move(marks)},
          {"grip_goal_R", goal ? vector_json(*goal) : nlohmann::ordered_json(nullptr)}};
}

}  // namespace markservo::mmi
