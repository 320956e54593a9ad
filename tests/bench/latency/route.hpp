#pragma once

// A way from a frame to its answer over the bus: the services' own, and one through empty processes.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace markservo::bench {

// One message on the way.
struct Stage {
  std::string name;     // of the process that writes it
  std::string channel;  // that it is written on
  // The seq of the frame that it answers; nothing if the bytes are no such message.
  std::optional<std::int64_t> (*frame_of)(const void* data, std::size_t size) = nullptr;
};

struct Route {
  std::string name;
  std::string url;            // of its bus: no other route's, so that none hears another's frames
  std::string frame_channel;  // where frames enter
  std::vector<Stage> stages;  // in order; the last one is the answer
  // Writes `frame_seq` into the encoded STEREO_FRAME, if the route's processes cannot read it there; else null.
  void (*stamp)(std::vector<std::uint8_t>& frame, std::int64_t frame_seq) = nullptr;
};

// STEREO_FRAME -> MARK_DETECTION -> TARGET_POSE -> JOINT_COMMAND, through the services.
Route chain_route(const std::string& url);

// As many messages through `latency-hop` processes, which know nothing of a message but its mark.
Route floor_route(const std::string& url);

// `url` with the next port: another bus, by LCM's rules. Throws std::invalid_argument unless it is udpm://GROUP:PORT...
// with a port of 1 to 65534.
std::string next_port(const std::string& url);

}  // namespace markservo::bench
