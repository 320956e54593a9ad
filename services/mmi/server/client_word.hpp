#pragma once

// What a client may say (README, "From a client"). Any bytes may come.

#include <cstdint>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "services/mmi/control/command.hpp"

namespace markservo::mmi {

inline constexpr int kProtocol = 1;

struct ClientHello {
  std::string token;
};
struct ClientPictures {
  bool on = false;
};
struct ClientSeen {
  std::int64_t picture = 0;
};
struct ClientTook {
  std::int64_t update = 0;
};
struct ClientLook {
  std::vector<std::string> channels;
};
struct ClientStop {
  std::string reason;
};
struct ClientPlay {
  double speed = 1.0;
};
struct ClientPause {};
struct ClientSeek {
  std::int64_t utime = 0;  // us
};
struct ClientStep {
  int frames = 1;
};
struct ClientLease {
  bool on = false;
  bool take = false;
};
struct ClientCommand {
  CommandStamp stamp;
  Command command;
};

using ClientWord = std::variant<ClientHello, ClientPictures, ClientSeen, ClientTook, ClientLook, ClientStop, ClientPlay,
                                ClientPause, ClientSeek, ClientStep, ClientLease, ClientCommand>;

inline constexpr std::size_t kMostLooked = 64;    // channels at once
inline constexpr std::size_t kLongestText = 512;  // bytes, of a reason, a name or a token
inline constexpr double kFastestPlay = 10.0;
inline constexpr double kFarthest = 1e4;  // m, of a place

// Throws std::invalid_argument: what is wrong, and what is allowed.
ClientWord parse_client_word(std::string_view text);

}  // namespace markservo::mmi
