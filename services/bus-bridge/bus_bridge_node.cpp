#include "services/bus-bridge/bus_bridge_node.hpp"

#include <poll.h>

#include <array>
#include <chrono>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "common/bus/options.hpp"
#include "common/bus/session.hpp"
#include "common/time/clocks.hpp"

namespace markservo::bus_bridge {
namespace {

using std::chrono::milliseconds;

constexpr milliseconds kLongestWait{100};  // for messages, so that the heartbeat and signals are not kept waiting

}  // namespace

Bridge::Bridge(bus::Bus& local, bus::Bus& link, const Crossing& crossing) : largest_(crossing.largest) {
  for (const std::string& channel : crossing.send) pass(channel, local, link);
  for (const std::string& channel : crossing.receive) pass(channel, link, local);
}

void Bridge::pass(const std::string& channel, bus::Bus& from, bus::Bus& to) {
  from.on_raw(channel, [this, channel, &to](const void* data, std::size_t size) {
    if (size > largest_) {
      throw std::invalid_argument("message of " + std::to_string(size) + " bytes; allowed: at most " +
                                  std::to_string(largest_) + " (--largest) cross");
    }
    const std::string_view bytes(static_cast<const char*>(data), size);
    if (!repeats_.crosses(bus::fingerprint(bytes, bus::fingerprint(channel)), steady_clock_us())) return false;
    return to.publish_raw(channel, data, size);
  });
}

void BusBridgeNode::add_options(CLI::App& app) {
  const bus::Options add(app);
  add.option("--link-url", crossing_.link_url,
             "The bus that both hosts share, udpm:// with ttl=1, on a port of its own");
  add.option("--send", crossing_.send, "Channels from this host's bus to the link, separated by commas").delimiter(',');
  add.option("--receive", crossing_.receive, "Channels from the link to this host's bus, separated by commas")
      .delimiter(',');
  add.option("--largest", crossing_.largest, "Larger messages do not cross, bytes").in_range(100, 65000).show_default();
}

void BusBridgeNode::configure(const std::string& /*robot_file*/) {
  bus_bridge::check(crossing_);
}

void BusBridgeNode::start(bus::Bus& bus) {
  check_beside(crossing_, bus.urls().in);
  check_beside(crossing_, bus.urls().out);
  bus::BusParameters parameters;
  parameters.urls = {crossing_.link_url, crossing_.link_url};
  parameters.service_name = "bus-bridge";
  parameters.robot = bus.robot();
  parameters.heartbeat = false;  // SERVICE_STATUS is this host's; it crosses as others' do
  parameters.waits_for_network = true;
  link_ = std::make_unique<bus::Bus>(std::move(parameters));
  bridge_ = std::make_unique<Bridge>(bus, *link_, crossing_);
  bus.report_also(*link_, "link:");
}

void BusBridgeNode::run(bus::Bus& bus) {
  do {
    std::array<pollfd, 2> waiting{{{bus.descriptor(), POLLIN, 0}, {link_->descriptor(), POLLIN, 0}}};
    ::poll(waiting.data(), waiting.size(), static_cast<int>(kLongestWait.count()));
  } while (link_->poll(milliseconds(0)) && bus.poll(milliseconds(0)));
}

}  // namespace markservo::bus_bridge
