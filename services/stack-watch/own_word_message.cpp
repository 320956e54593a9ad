#include "services/stack-watch/own_word_message.hpp"

#include <unistd.h>

#include <markservo/ServiceStatus.hpp>
#include <markservo/channels.hpp>

#include "common/bus/host_name.hpp"
#include "common/bus/robot_channel.hpp"
#include "common/bus/session.hpp"
#include "common/census/census.hpp"
#include "services/stack-watch/short_message_of.hpp"

namespace markservo::stack_watch {
namespace {

constexpr std::size_t kMaxReason = 200;  // bytes, as any text on the bus

}  // namespace

OwnWord::OwnWord(const std::string& robot)
    : channel_(bus::robot_channel(robot, channels::kServiceStatus.name)),
      host_(bus::host_name()),
      session_(bus::random_session()) {}

std::vector<std::uint8_t> OwnWord::next(bool well, const std::string& reason, std::int64_t wall_us) {
  ServiceStatus status{};
  status.reason = reason.substr(0, kMaxReason);
  status.utime = wall_us;
  status.session = session_;
  status.seq = ++seq_;
  status.name = census::kStackWatch;
  status.host = host_;
  status.pid = getpid();
  status.version = MARKSERVO_VERSION;
  status.state = well ? "ready" : "stale";
  return short_message_of(status, channel_);
}

}  // namespace markservo::stack_watch
