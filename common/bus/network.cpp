#include "common/bus/network.hpp"

#include <utility>

#include "common/bus/bus_unavailable.hpp"

namespace markservo::bus {
namespace {

// So many heartbeats were sent, and neither they nor anything else came in: the bus is deaf.
constexpr int kDeafAfter = 3;

}  // namespace

Network::Network(const BusUrls& urls, bool waits, Connection::Attach attach)
    : waits_(waits),
      replaying_(is_file(urls.in) && !is_written_file(urls.in)),
      in_(std::make_shared<Connection>(urls.in, std::move(attach))),
      out_(urls.out == urls.in ? in_ : std::make_shared<Connection>(urls.out, nullptr)) {}

void Network::open() {
  for (Connection* connection : {in_.get(), out_.get()}) {
    if (connection->lcm() != nullptr || connection->open()) continue;
    // A server's address may be a slip; a route that is missing is not.
    if (!waits_ || !is_udpm(connection->url())) {
      throw BusUnavailable("bus " + connection->url() + ": cannot be joined: " + connection->trouble());
    }
  }
}

void Network::mend(Connection::Time now) {
  for (Connection* connection : {in_.get(), out_.get()}) {
    if (connection->is_open()) continue;
    if (!waits_) throw BusUnavailable("bus " + connection->url() + ": " + connection->trouble());
    if (connection->mend(now)) heartbeats_unheard_ = 0;
  }
  if (echo_ && heartbeats_unheard_ >= kDeafAfter) {
    heartbeats_unheard_ = 0;
    lose_input("hears nothing, not even what it sends itself", now);
  }
}

void Network::lose_input(const std::string& why, Connection::Time now) {
  const bool is_network = is_udpm(in_->url()) || is_tcpq(in_->url());
  if (!is_network || !waits_) throw BusUnavailable("bus " + in_->url() + ": " + why);
  in_->lose(why, now);
}

std::optional<Health> Network::health(Connection::Time now) const {
  for (const Connection* connection : {in_.get(), out_.get()}) {
    if (!connection->is_open()) return Health{kWaiting, "no network: " + connection->trouble()};
  }
  const RefusedSends refused = out_->refused_sends(now);
  if (refused.lately == 0) return std::nullopt;
  const std::string who = is_file(out_->url()) ? "log " + file_path(out_->url()) : "the network";
  return Health{kWaiting, who + " refuses " + refused.channel + ": " + refused.reason};
}

}  // namespace markservo::bus
