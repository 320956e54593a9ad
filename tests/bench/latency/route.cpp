#include "tests/bench/latency/route.hpp"

#include <markservo/JointCommand.hpp>
#include <markservo/MarkDetection.hpp>
#include <markservo/TargetPose.hpp>
#include <markservo/channels.hpp>
#include <stdexcept>

#include "common/bus/bus_url.hpp"
#include "common/bus/safe_decode.hpp"
#include "tests/bench/latency/hop_mark.hpp"

namespace markservo::bench {
namespace {

constexpr int kMaxPort = 65535;

template <class M>
std::optional<std::int64_t> answered_frame(const void* data, std::size_t size) {
  const bus::Decoded<M> decoded = bus::safe_decode<M>(data, size);
  if (!decoded.ok) return std::nullopt;
  return decoded.message.frame_seq;
}

void stamp_mark(std::vector<std::uint8_t>& frame, std::int64_t frame_seq) {
  put_hop_mark(frame.data(), frame_seq);
}

}  // namespace

Route chain_route(const std::string& url) {
  return {"chain",
          url,
          channels::kStereoFrame.name,
          {{"mark-detector", channels::kMarkDetection.name, answered_frame<MarkDetection>},
           {"target-locator", channels::kTargetPose.name, answered_frame<TargetPose>},
           {"visual-servo", channels::kJointCommand.name, answered_frame<JointCommand>}},
          nullptr};
}

Route floor_route(const std::string& url) {
  return {"floor",
          url,
          "HOP_0",
          {{"hop-1", "HOP_1", hop_mark}, {"hop-2", "HOP_2", hop_mark}, {"hop-3", "HOP_3", hop_mark}},
          stamp_mark};
}

std::string next_port(const std::string& url) {
  const auto wrong = [&] {
    return std::invalid_argument("bus " + url + ": no port to count on from; allowed: udpm://GROUP:PORT, 1 to 65534");
  };
  const std::size_t colon = url.find(':', std::string("udpm://").size());
  if (!bus::is_udpm(url) || colon == std::string::npos) throw wrong();
  std::size_t end = url.find_first_not_of("0123456789", colon + 1);
  if (end == std::string::npos) end = url.size();
  constexpr std::size_t kMaxDigits = 5;
  const std::size_t num_digits = end - colon - 1;
  if (num_digits < 1 || num_digits > kMaxDigits) throw wrong();
  const int port = std::stoi(url.substr(colon + 1, num_digits));
  if (port < 1 || port >= kMaxPort) throw wrong();
  return url.substr(0, colon + 1) + std::to_string(port + 1) + url.substr(end);
}

}  // namespace markservo::bench
