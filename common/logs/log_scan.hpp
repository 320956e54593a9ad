#pragma once

#include <functional>
#include <vector>

#include "common/logs/log_event.hpp"

namespace markservo::logs {

// Whether a message's bytes can be one of its type.
enum class Fit { kFits, kDoesNot, kUnknownType };
using FitCheck = std::function<Fit(ByteView message)>;

struct Scan {
  std::vector<LogEvent> events;  // in the log's order; they refer to its bytes
  std::vector<Damage> damage;    // what is no event, in order
};

// Reads any bytes as a log. Where they are damaged, everything outside the damage is kept: the event before a corrupt
// sync word, which liblcm drops, the event behind it, and an event whose size lost one bit. `fit` decides where the
// structure alone does not. Bytes that are no log at all come back as one damage.
Scan scan(ByteView log, const FitCheck& fit);

}  // namespace markservo::logs
