#include "services/mmi/scene/hello_json.hpp"

#include <cstddef>
#include <markservo/channels.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "common/task/transitions.hpp"
#include "services/mmi/scene/state_names.hpp"

namespace markservo::mmi {
namespace {

using Json = nlohmann::ordered_json;

Json words_json(std::string_view words) {
  Json list = Json::array();
  while (!words.empty()) {
    const std::size_t blank = words.find(' ');
    list.push_back(std::string(words.substr(0, blank)));
    words.remove_prefix(blank == std::string_view::npos ? words.size() : blank + 1);
  }
  return list;
}

// What the simulator alone knows and tells; what commands the simulated world is none.
bool is_truth(const channels::Entry& channel) {
  constexpr std::string_view kSimulators = "SIM_";
  return std::string_view(channel.name).substr(0, kSimulators.size()) == kSimulators && !channel.moves_robot;
}

Json channels_json() {
  Json list = Json::array();
  for (const channels::Entry& channel : channels::kAll) {
    list.push_back({{"name", channel.name},
                    {"type", channel.type},
                    {"what", channel.what},
                    {"writers", words_json(channel.writers)},
                    {"readers", words_json(channel.readers)},
                    {"truth", is_truth(channel)},
                    {"moves_robot", channel.moves_robot}});
  }
  return list;
}

Json transitions_json(const std::vector<std::string>& phases) {
  const auto name = [&](TaskPhase phase) { return phases.at(static_cast<std::size_t>(phase)); };
  Json list = Json::array();
  for (const TaskTransition& transition : kTaskTransitions) {
    list.push_back({{"from", name(transition.from)}, {"to", name(transition.to)}, {"when", transition.when}});
  }
  return list;
}

}  // namespace

Json vocabulary_json() {
  const std::vector<std::string> phases = state_names("TaskState", "state");
  return {{"channels", channels_json()},
          {"phases", phases},
          {"transitions", transitions_json(phases)},
          {"states",
           {{"SERVO_STATUS", state_names("ServoStatus", "state")},
            {"BASE_STATUS", state_names("BaseStatus", "state")},
            {"ROBOT_POSE", state_names("RobotPose", "state")},
            {"PROCESS_STATUS", state_names("ProcessStatus", "state")},
            {"MARK", state_names("LocatedMark", "status")},
            {"CUE", state_names("LocatedMark", "cue")}}}};
}

}  // namespace markservo::mmi
