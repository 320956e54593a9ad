#pragma once

// Whether services may be started on a bus: nobody else may write there what one alone may write.

#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "common/census/census.hpp"

namespace markservo::bus_census {

struct RoomWish {
  std::vector<std::string> services;    // what shall be started
  std::optional<std::string> robot;     // its channels' prefix, empty for none; nothing: any robot's count
  std::string host;                     // where they shall be started,
  std::set<int> own;                    // and the processes there that are no obstacle: those that they replace,
  std::set<std::int64_t> own_sessions;  // and what they write by, where that is known
};

// Whether one of the services writes what one alone may write. None does: nobody can be in its way.
bool needs_room(const std::vector<std::string>& services);

// Whether somebody writes what one of the services alone may write and has not said yet who it is.
bool somebody_is_unknown(const census::Report& report, const RoomWish& wish);

// One line for each writer of channels that one of the services alone may write, as the table of channels says, with
// those channels; and one for each of the services that somebody else runs, even if it has written nothing yet. None:
// there is room. The lines are printable ASCII, whatever was heard.
std::vector<std::string> obstacles(const census::Report& report, const RoomWish& wish);

}  // namespace markservo::bus_census
