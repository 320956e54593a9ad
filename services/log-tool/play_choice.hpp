#pragma once

// What of a log may go to a bus that a robot may be on. Pure: who is on the bus is told.

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "common/channel_pattern/channel_pattern.hpp"
#include "common/logs/log_event.hpp"
#include "common/reflection/type_catalog.hpp"

namespace markservo::log_tool {

// What liblcm asks itself at every start of a program: is there a bus? It stands in every recording, and says nothing.
inline constexpr const char* kLcmSelfTest = "LCM_SELF_TEST";

struct PlayWishes {
  std::optional<ChannelPattern> channels;  // none: all
  bool all = false;                        // also what moves a robot, and what is live
  bool join = false;                       // beside others: see Fate
  bool by_udp = true;                      // the bus loses what is too large (bus_limits.hpp)
  std::set<std::string> written;           // the channels that somebody writes on the bus

  // Another system's commands move its robot, and nobody here knows which they are: what our table of channels does not
  // have, or a type that is not ours, is played where it is named. A pattern that takes any name ('.*', '\w+')
  // names nothing by itself.
  bool names_others() const { return channels && (all || !channels->takes_any_name()); }
};

// What becomes of a channel of the log.
enum class Fate {
  kPlayed,
  kNotNamed,     // by PlayWishes::channels; or liblcm's own
  kNoName,       // no bus carries it: empty, longer than 63 bytes, or with a zero byte in it
  kMoves,        // it moves a robot or releases it
  kLive,         // it speaks for a device or process that is not there
  kUnlisted,     // the table of channels does not have it, and it is not named
  kWritten,      // join: somebody writes it
  kFeedsMotion,  // join: what moves would decide by it
};

// A robot's prefix ("r1/") is no part of a channel's name in the table.
Fate fate_of(const std::string& channel, const PlayWishes& wishes);

struct TooLarge {
  std::int64_t messages = 0;
  std::size_t largest = 0;  // bytes
};

struct PlayPlan {
  std::vector<logs::LogEvent> events;                 // what is played, in the log's order
  std::map<Fate, std::vector<std::string>> left_out;  // channels by what became of them, kPlayed apart
  std::set<std::string> played;                       // channels
  // Messages left out on channels that are played.
  std::map<std::string, std::int64_t> moving_messages;  // of a type that moves a robot; all wishes for them
  std::map<std::string, std::int64_t> others_messages;  // of a type that is not ours; to be named
  std::map<std::string, TooLarge> too_large;            // for the bus
};

// `types` tells a message's type by its fingerprint. Every message is looked at, which takes minutes for a long log:
// that is given up, and the plan holds what was seen until then, as soon as `goes_on` says no.
PlayPlan plan_of(
    const std::vector<logs::LogEvent>& events, const PlayWishes& wishes, const reflection::TypeCatalog& types,
    const std::function<bool()>& goes_on = [] { return true; });

// One line, without its end, for each kind of thing left out (kNotNamed apart), with the reason and what plays it;
// printable ASCII, whatever the log's names are.
std::vector<std::string> left_out_text(const PlayPlan& plan);

// One such line of the channels that are played although the table of channels does not have them; empty without any.
std::string others_played_text(const PlayPlan& plan);

}  // namespace markservo::log_tool
