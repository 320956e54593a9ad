#pragma once

// What the services say in SERVICE_STATUS of the messages they read.

#include <map>
#include <markservo/ServiceStatus.hpp>
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "common/bus/bus.hpp"

namespace markservo::experiments {

class BusCounts {
 public:
  explicit BusCounts(bus::Bus& bus);

  // An array of {service, host, channel, received, skipped, lost, refused}: the last word of each service on each
  // channel it heard.
  nlohmann::json report() const;

 private:
  std::map<std::string, ServiceStatus> last_;  // by host and name
};

}  // namespace markservo::experiments
