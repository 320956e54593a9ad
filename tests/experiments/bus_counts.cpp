#include "tests/experiments/bus_counts.hpp"

#include <nlohmann/json.hpp>

namespace markservo::experiments {

BusCounts::BusCounts(bus::Bus& bus) {
  bus.on_each(channels::kServiceStatus,
              [this](const ServiceStatus& status) { last_[status.host + "/" + status.name] = status; });
}

nlohmann::json BusCounts::report() const {
  nlohmann::json counts = nlohmann::json::array();
  for (const auto& [name, status] : last_) {
    for (const ChannelStatus& channel : status.channels) {
      if (channel.received == 0 && channel.refused == 0) continue;
      counts.push_back({{"service", status.name},
                        {"host", status.host},
                        {"channel", channel.channel},
                        {"received", channel.received},
                        {"skipped", channel.skipped},
                        {"lost", channel.lost},
                        {"refused", channel.refused}});
    }
  }
  return counts;
}

}  // namespace markservo::experiments
