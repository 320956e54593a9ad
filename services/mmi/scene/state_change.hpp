#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>

namespace markservo::mmi {

enum class ChangeKind { kTask, kServo, kBase, kPose, kStop, kService, kProcess, kRecording, kCommand, kTrouble };
enum class Level { kInfo, kGood, kWarning, kBad };

// An event of the page's list.
struct StateChange {
  std::int64_t number = 0;  // from 1, without a gap
  std::int64_t at = 0;      // us, arrival
  std::string channel;      // without a robot's prefix; empty of a trouble
  std::string key;          // which of many; else empty
  ChangeKind kind = ChangeKind::kTask;
  std::string state;  // "GRIP", "latched", a service's own word, ...
  std::string text;   // one line for people
  Level level = Level::kInfo;
};

// As `events` of an update has it.
nlohmann::ordered_json json_of(const StateChange& change);

}  // namespace markservo::mmi
