#include "services/mmi/scene/state_change.hpp"

namespace markservo::mmi {
namespace {

const char* name_of(ChangeKind kind) {
  switch (kind) {
    case ChangeKind::kTask:
      return "task";
    case ChangeKind::kServo:
      return "servo";
    case ChangeKind::kBase:
      return "base";
    case ChangeKind::kPose:
      return "pose";
    case ChangeKind::kStop:
      return "stop";
    case ChangeKind::kService:
      return "service";
    case ChangeKind::kProcess:
      return "process";
    case ChangeKind::kRecording:
      return "recording";
    case ChangeKind::kCommand:
      return "command";
    case ChangeKind::kTrouble:
      break;
  }
  return "trouble";
}

const char* name_of(Level level) {
  switch (level) {
    case Level::kInfo:
      return "info";
    case Level::kGood:
      return "good";
    case Level::kWarning:
      return "warning";
    case Level::kBad:
      break;
  }
  return "bad";
}

}  // namespace

nlohmann::ordered_json json_of(const StateChange& change) {
  return {{"number", change.number}, {"at", std::to_string(change.at)}, {"channel", change.channel},
          {"key", change.key},       {"kind", name_of(change.kind)},    {"state", change.state},
          {"text", change.text},     {"level", name_of(change.level)}};
}

}  // namespace markservo::mmi
