#pragma once

// What of a log may go to a bus that a robot may be on. Pure: who is on the bus is told.

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "common/reflection/type_catalog.hpp"
#include "services/log-tool/log_event.hpp"
#include "services/log-tool/name_expression.hpp"

namespace markservo::log_tool {

struct PlayWishes {
  std::optional<NameExpression> channels;  // none: all
  bool all = false;                        // also what moves a robot, what is live, and what the table does not have
  bool join = false;                       // beside others: see Fate
  std::set<std::string> written;           // the channels that somebody writes on the bus
};

// What becomes of a channel of the log.
enum class Fate {
  kPlayed,
  kNotNamed,     // by PlayWishes::channels
  kNoName,       // no bus carries it: empty, longer than 63 bytes, or with a zero byte in it
  kMoves,        // it moves a robot or releases it
  kLive,         // it speaks for a device or process that is not there
  kUnlisted,     // the table of channels does not have it, and nobody named it
  kWritten,      // join: somebody writes it
  kFeedsMotion,  // join: what moves would decide by it
};

// A robot's prefix ("r1/") is no part of a channel's name in the table.
Fate fate_of(const std::string& channel, const PlayWishes& wishes);

struct PlayPlan {
  std::vector<Event> events;                          // what is played, in the log's order
  std::map<Fate, std::vector<std::string>> left_out;  // channels by what became of them, kPlayed apart
  std::set<std::string> played;                       // channels
  // Messages on channels that are played, which carry a type that moves a robot: left out unless all is wished for.
  std::map<std::string, std::int64_t> moving_messages;
};

// `types` tells a message's type by its fingerprint. Every message is looked at, which takes minutes for a long log:
// that is given up, and the plan holds what was seen until then, as soon as `goes_on` says no.
PlayPlan plan_of(
    const std::vector<Event>& events, const PlayWishes& wishes, const reflection::TypeCatalog& types,
    const std::function<bool()>& goes_on = [] { return true; });

// One line, without its end, for each kind of thing left out (kNotNamed apart), with the reason and what plays it;
// printable ASCII, whatever the log's names are.
std::vector<std::string> left_out_text(const PlayPlan& plan);

}  // namespace markservo::log_tool
