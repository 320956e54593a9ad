#include "services/mmi/scene/hello_json.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <markservo/channels.hpp>
#include <set>
#include <stdexcept>
#include <string>

#include "common/task/transitions.hpp"
#include "services/mmi/scene/state_names.hpp"

namespace markservo::mmi {
namespace {

using Json = nlohmann::ordered_json;

Json channel(const std::string& name) {
  const Json channels = vocabulary_json()["channels"];
  for (const Json& entry : channels) {
    if (entry["name"] == name) return entry;
  }
  return nullptr;
}

TEST(Vocabulary, HasEveryChannelOfTheTable) {
  EXPECT_EQ(vocabulary_json()["channels"].size(), channels::kAll.size());
  const Json goal = channel("SERVO_GOAL");
  EXPECT_EQ(goal["type"], "ServoGoal");
  EXPECT_EQ(goal["writers"], Json({"task-manager"}));
  EXPECT_EQ(goal["moves_robot"], true);
  EXPECT_EQ(goal["truth"], false);
  EXPECT_FALSE(goal["what"].get<std::string>().empty());
  EXPECT_EQ(channel("STEREO_FRAME")["writers"], Json({"stereo-camera", "simulator"}));
  EXPECT_EQ(channel("STEREO_MATCHES")["readers"], Json::array());
}

TEST(Vocabulary, TellsTheSimulatorsOwnKnowledge) {
  std::set<std::string> truths;
  const Json channels = vocabulary_json()["channels"];
  for (const Json& entry : channels) {
    if (entry["truth"] == true) truths.insert(entry["name"]);
  }
  EXPECT_EQ(truths, (std::set<std::string>{"SIM_BASE_TRUTH", "SIM_TRUTH"}));
}

TEST(Vocabulary, NamesThePhasesByNumber) {
  const Json phases = vocabulary_json()["phases"];
  ASSERT_EQ(phases.size(), static_cast<std::size_t>(TaskPhase::kDrive) + 1);
  EXPECT_EQ(phases[0], "IDLE");
  EXPECT_EQ(phases[static_cast<std::size_t>(TaskPhase::kGoHome)], "GO_HOME");
  EXPECT_EQ(phases[static_cast<std::size_t>(TaskPhase::kDrive)], "DRIVE");
}

TEST(Vocabulary, HasTheTransitionsByName) {
  const Json transitions = vocabulary_json()["transitions"];
  EXPECT_EQ(transitions.size(), std::size(kTaskTransitions));
  EXPECT_EQ(transitions[0], Json({{"from", "DRIVE"}, {"to", "LOOK"}, {"when", "arrived"}}));
}

TEST(Vocabulary, NamesTheStatesByNumber) {
  const Json states = vocabulary_json()["states"];
  EXPECT_EQ(states["SERVO_STATUS"],
            Json({"HOLD", "POSTURE", "SERVO", "CONVERGED", "LOST", "UNREACHABLE", "STALE", "STOPPED"}));
  EXPECT_EQ(states["BASE_STATUS"], Json({"HOLD", "DRIVING", "ARRIVED", "BLOCKED", "LOST", "STALE", "STOPPED"}));
  EXPECT_EQ(states["ROBOT_POSE"], Json({"SEARCHING", "LOCALISED", "LOST"}));
  EXPECT_EQ(states["PROCESS_STATUS"], Json({"STOPPED", "STARTING", "RUNNING", "SILENT", "WAITING", "ENDED", "FAILED"}));
  EXPECT_EQ(states["MARK"], Json({"LOCATED", "UNSEEN", "SEEN_BY_ONE", "CLIPPED", "TOO_FEW_MATCHES", "INCONSISTENT"}));
  EXPECT_EQ(states["CUE"], Json({"CUE_NONE", "CUE_TEXTURE", "CUE_OUTLINE", "CUE_CENTROID"}));
}

TEST(StateNames, AreThoseOfAFieldThatConstantsName) {
  EXPECT_EQ(state_names("StopRequest", "kind"), (std::vector<std::string>{"STOP", "RESET"}));
  EXPECT_THROW(state_names("StopRequest", "reason"), std::invalid_argument);
  EXPECT_THROW(state_names("NoSuchType", "state"), std::invalid_argument);
}

}  // namespace
}  // namespace markservo::mmi
