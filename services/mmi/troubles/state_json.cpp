#include "services/mmi/troubles/state_json.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <string>

namespace markservo::mmi {
namespace {

using Json = nlohmann::ordered_json;

// "GO_HOME" of "go home", as the messages' constants are written.
std::string constant(std::string words) {
  std::transform(words.begin(), words.end(), words.begin(),
                 [](unsigned char letter) { return letter == ' ' ? '_' : static_cast<char>(std::toupper(letter)); });
  return words;
}

// As TaskState.lcm names them.
std::string phase_name(TaskPhase phase) {
  return phase == TaskPhase::kHoldLifted ? "HOLD_LIFTED" : constant(name_of(phase));
}

const char* result_name(TaskResult result) {
  switch (result) {
    case TaskResult::kNone:
      break;
    case TaskResult::kLifted:
      return "LIFTED";
    case TaskResult::kRefused:
      return "REFUSED";
    case TaskResult::kFailed:
      return "FAILED";
  }
  return "NONE";
}

Json number(double value) {
  return std::isfinite(value) ? Json(value) : Json(nullptr);
}

Json task_json(const RobotState& state) {
  const TaskWord& task = *state.task();
  return {{"state", phase_name(task.phase)},
          {"target", task.target},
          {"reason", task.reason},
          {"result", result_name(task.result)},
          {"since_utime", std::to_string(state.task_since_utime())},
          {"at_utime", std::to_string(task.at)},
          {"text", state.activity()}};
}

Json pose_json(const PoseWord& pose) {
  return {{"x", number(pose.X_WR.x)},
          {"y", number(pose.X_WR.y)},
          {"heading", number(pose.X_WR.heading)},
          {"state", constant(name_of(pose.state))},
          {"sigma_x", number(pose.sigma_x)},
          {"sigma_y", number(pose.sigma_y)},
          {"reason", pose.reason},
          {"at_utime", std::to_string(pose.at)}};
}

Json recording_json(const RecorderWord& recorder) {
  return {{"folder", recorder.folder},
          {"recording", recorder.recording},
          {"bytes", std::to_string(recorder.bytes)},
          {"free_bytes", std::to_string(recorder.free_bytes)},
          {"parts", recorder.parts},
          {"why", recorder.why},
          {"at_utime", std::to_string(recorder.at)}};
}

}  // namespace

Json troubles_json(const std::vector<Trouble>& troubles) {
  Json list = Json::array();
  for (const Trouble& trouble : troubles) {
    list.push_back({{"code", name_of(trouble.code)},
                    {"subject", trouble.subject},
                    {"since_utime", std::to_string(trouble.since_utime)},
                    {"text", trouble.text},
                    {"remedy", trouble.remedy}});
  }
  return list;
}

Json state_json(const RobotState& state, const std::vector<Trouble>& troubles) {
  Json json;
  json["task"] = state.task() ? task_json(state) : Json(nullptr);
  json["pose"] = state.pose() ? pose_json(*state.pose()) : Json(nullptr);
  json["recording"] = state.recorder() ? recording_json(*state.recorder()) : Json(nullptr);
  json["troubles"] = troubles_json(troubles);
  return json;
}

}  // namespace markservo::mmi
