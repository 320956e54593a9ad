#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "common/bus/bus_url.hpp"
#include "common/bus/connection.hpp"
#include "common/bus/health.hpp"
#include "common/bus/subscription.hpp"

namespace markservo::bus {

// The connections that a Bus hears and speaks by, held through what happens to the network. A deaf one shows by the
// service's own heartbeats, which do not come back.
class Network {
 public:
  // `attach` as Connection's, of what is heard. `waits`: for a route, an interface or a server that is missing.
  Network(const BusUrls& urls, bool waits, Connection::Attach attach);

  // Who hears the service's own heartbeats among others'. Without one nobody can tell that the bus is deaf.
  void hear_itself_by(std::unique_ptr<Subscription> echo) { echo_ = std::move(echo); }
  Subscription* echo() const { return echo_.get(); }
  // Whether heartbeats sent on it come back.
  bool returns_heartbeats() const { return in_ == out_ && is_udpm(in_->url()); }

  // Opens both. Throws BusUnavailable for what is not waited for.
  void open();
  // Sees to what is lost or deaf. Throws likewise.
  void mend(Connection::Time now);
  // What is heard cannot be read any more. Throws likewise.
  void lose_input(const std::string& why, Connection::Time now);

  void note_traffic() { heartbeats_unheard_ = 0; }
  void note_heartbeat() {
    if (out_->is_open()) ++heartbeats_unheard_;
  }

  // What keeps a service on it from its work.
  std::optional<Health> health(Connection::Time now) const;

  Connection& in() const { return *in_; }
  Connection& out() const { return *out_; }
  // What is heard is a log: nothing about it is live.
  bool replaying() const { return replaying_; }

 private:
  bool waits_;
  bool replaying_;
  std::shared_ptr<Connection> in_;
  std::shared_ptr<Connection> out_;     // the same where one URL serves both
  std::unique_ptr<Subscription> echo_;  // of SERVICE_STATUS, this service's own among them
  int heartbeats_unheard_ = 0;          // sent since anything was heard
};

}  // namespace markservo::bus
