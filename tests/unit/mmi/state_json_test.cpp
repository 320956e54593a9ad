#include "services/mmi/troubles/state_json.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace markservo::mmi {
namespace {

using Json = nlohmann::ordered_json;

TEST(StateJson, IsNullWhereNothingWasHeard) {
  EXPECT_EQ(state_json({}, {}).dump(), R"({"task":null,"pose":null,"recording":null,"troubles":[]})");
}

TEST(StateJson, SaysTheTaskAsItsMessageNamesIt) {
  RobotState state;
  state.observe(TaskWord{1234, TaskPhase::kHoldLifted, TaskResult::kLifted, "red_book", ""});
  EXPECT_EQ(state_json(state, {})["task"],
            Json::parse(R"({"state": "HOLD_LIFTED", "target": "red_book", "reason": "", "result": "LIFTED",
                            "since_utime": "1234", "at_utime": "1234", "text": "lifted: red_book"})"));
  state.observe(TaskWord{1235, TaskPhase::kLiftOn, TaskResult::kNone, "red_book", "lifting on"});
  EXPECT_EQ(state_json(state, {})["task"]["state"], "LIFT_ON");
}

TEST(StateJson, SaysThePoseAndWhatIsNotFiniteIsNull) {
  RobotState state;
  state.observe(PoseWord{1, LocalisationState::kLost, {1.0, 2.0, 0.5}, 0.25, NAN, "the reads contradict the pose"});
  EXPECT_EQ(state_json(state, {})["pose"],
            Json::parse(R"({"x": 1.0, "y": 2.0, "heading": 0.5, "state": "LOST", "sigma_x": 0.25, "sigma_y": null,
                            "reason": "the reads contradict the pose", "at_utime": "1"})"));
}

TEST(StateJson, SaysTheRecording) {
  RobotState state;
  state.observe(RecorderWord{1, "logs/today", "host", true, 9007199254740993, 5, 2, ""});
  EXPECT_EQ(state_json(state, {})["recording"],
            Json::parse(R"({"folder": "logs/today", "recording": true, "bytes": "9007199254740993",
                            "free_bytes": "5", "parts": 2, "why": "", "at_utime": "1"})"));
}

TEST(StateJson, ListsTheTroublesAsGiven) {
  const std::vector<Trouble> troubles{{TroubleCode::kPoseLost, "base", 7, "lost", "push it"},
                                      {TroubleCode::kMmiLost, "mmi", 8, "no word", "reload"}};
  EXPECT_EQ(troubles_json(troubles),
            Json::parse(R"([{"code": "pose_lost", "subject": "base", "since_utime": "7", "text": "lost",
                             "remedy": "push it"},
                            {"code": "mmi_lost", "subject": "mmi", "since_utime": "8", "text": "no word",
                             "remedy": "reload"}])"));
}

}  // namespace
}  // namespace markservo::mmi
