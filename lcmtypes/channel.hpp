#pragma once

// What lcmtypes/channels.yaml says of a channel. The channels themselves are in <markservo/channels.hpp>, which the
// build makes of that file; it names their types and includes none of them.

#include <cstddef>
#include <string_view>

namespace markservo::channels {

// What a second writer of a channel means.
enum class Second {
  kAllowed,  // many write by design; neither loss nor writers are counted
  kIgnored,  // one writes; a second is named in SERVICE_STATUS, and of goals only the first is followed
  kHold,     // one writes; while two do, what moves by it holds until somebody resets
};

enum class Repeat {
  kNone,         // each message is new
  kSteadily,     // at 5 Hz of message time, SERVICE_STATUS at 1 Hz of the clock
  kUntilEchoed,  // at 5 Hz until the answer carries its id
};

// A channel of any type, for tools. The defaults are those of a channel that a test makes up.
struct Entry {
  const char* name;       // without a robot's prefix
  const char* type = "";  // without its package
  Second second = Second::kIgnored;
  bool moves_robot = false;   // a message makes a robot move, or releases it
  bool feeds_motion = false;  // what moves decides by it, directly or through other services
  bool live = false;          // speaks for a device or process that is there now
  Repeat repeat = Repeat::kNone;
  bool large = false;        // may exceed 9,000 bytes
  const char* what = "";     // what it is for
  const char* writers = "";  // services, one blank between; "all", "person"
  const char* readers = "";  // services
};

// A channel and the type of its messages.
template <class M>
struct Channel : Entry {
  constexpr explicit Channel(const Entry& entry) : Entry(entry) {}
};

// Whether `names`, an entry's writers or readers, has `name`.
constexpr bool has(std::string_view names, std::string_view name) {
  while (!names.empty()) {
    const std::size_t blank = names.find(' ');
    if (names.substr(0, blank) == name) return true;
    names.remove_prefix(blank == std::string_view::npos ? names.size() : blank + 1);
  }
  return false;
}

}  // namespace markservo::channels
