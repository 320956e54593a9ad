#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "services/mmi/scene/reports.hpp"
#include "services/mmi/scene/state_change.hpp"

namespace markservo::mmi {

// What a report says of a state, in words, to be compared with what its writer said before.
struct Saying {
  ChangeKind kind = ChangeKind::kTask;
  std::string channel;
  std::string key;
  std::int64_t session = 0;  // of the writer
  std::string subject;       // for the text's begin: "base", "visual-servo@robot"
  std::string state;
  std::string detail;  // for the text's end: ": something stands 0.31 m ahead"
  std::string gist;    // besides `state`, what makes it another saying
  Level level = Level::kInfo;
};

// Nothing for a report that is of no state.
std::optional<Saying> saying_of(const Report& report);

// What a STOP or TASK_COMMAND asks for.
struct Request {
  std::string channel;
  std::int64_t session = 0;
  std::int64_t id = 0;
  std::string state;
  std::string text;
  Level level = Level::kInfo;
};

// Nothing for a report that is no request.
std::optional<Request> request_of(const Report& report);

}  // namespace markservo::mmi
