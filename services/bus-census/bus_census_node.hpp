#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>

#include "common/bus/listener.hpp"
#include "common/census/census.hpp"

namespace markservo::bus_census {

// Listens to all of a bus and writes nothing on it.
class BusCensusNode {
 public:
  // Throws bus::BusUnavailable with a line that says what to do. `status_only`: only SERVICE_STATUS is listened to.
  BusCensusNode(const std::string& url, bool status_only);

  // Called with every SERVICE_STATUS, if set.
  std::function<void(const census::ServiceWord&)> on_status;

  // Until `seconds` have passed or it is told to end (SIGINT, SIGTERM).
  void listen(double seconds);
  // So much longer.
  void listen_on(double seconds);

  census::Report report() const;

 private:
  void on_message(const bus::HeardBytes& message);

  bus::Listener listener_;
  std::optional<census::Census> census_;
  std::int64_t end_us_ = 0;  // when listening ended, us
};

}  // namespace markservo::bus_census
