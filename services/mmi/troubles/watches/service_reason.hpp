#pragma once

// What SERVICE_STATUS's reason says of a channel, in the words of common/bus: "r1/STEREO_FRAME: not heard yet",
// "STEREO_FRAME: all refused: utime is 3600 s ahead of this host's clock; allowed: at most 20 ms".

#include <string>

namespace markservo::mmi {

// `channel` without a robot's prefix.
inline std::string without_robot(const std::string& channel) {
  return channel.substr(channel.rfind('/') + 1);
}

// The channel, without a robot's prefix, that the reason begins with; anything else gives no channel's name.
inline std::string channel_in(const std::string& reason) {
  return without_robot(reason.substr(0, reason.find(':')));
}

// Messages are refused, since they come from the future.
inline bool tells_of_a_clock(const std::string& reason) {
  return reason.find("ahead of this host's clock") != std::string::npos;
}

}  // namespace markservo::mmi
