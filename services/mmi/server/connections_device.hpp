#pragma once

// The connections of server_device, over any stream of Boost.Beast.

#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/local/stream_protocol.hpp>
#include <chrono>
#include <memory>
#include <optional>
#include <set>

#include "services/mmi/server/server_device.hpp"

namespace markservo::mmi {

std::chrono::steady_clock::duration duration_of(double seconds);

class Connection {
 public:
  using Time = std::chrono::steady_clock::time_point;

  virtual ~Connection() = default;
  virtual void wake() {}
  virtual bool converses() const { return false; }
  // Since when nothing has come of it, where its place may be another's; nothing while it is at work.
  virtual std::optional<Time> idle_since() const = 0;
  virtual void end() = 0;
};

// What all connections of a server share. Each is in `connections` for as long as it has a place.
struct ServerShared {
  ServerShared(ServerParameters its_parameters, WebSite& its_site)
      : parameters(std::move(its_parameters)), site(its_site) {}

  // A connection may end, and leave, while it is woken or ended.
  void wake();
  void end();
  // Whether there is a place for one more: where all are taken, that of the longest idle, requests before
  // conversations, is given away, which is counted.
  bool make_room();

  ServerParameters parameters;
  WebSite& site;
  Refusals refusals;
  std::set<Connection*> connections;
  bool ended = false;
};

// A member of its server's connections for as long as it lives.
class Registered : public Connection {
 public:
  explicit Registered(std::shared_ptr<ServerShared> shared) : shared_(std::move(shared)) {
    shared_->connections.insert(this);
  }
  ~Registered() override { shared_->connections.erase(this); }
  Registered(const Registered&) = delete;
  Registered& operator=(const Registered&) = delete;

 protected:
  std::shared_ptr<ServerShared> shared_;
};

// Reads requests from `socket` and answers them until it ends; closes it at once when there are too many.
void serve_connection(boost::asio::ip::tcp::socket socket, const std::shared_ptr<ServerShared>& shared);
void serve_connection(boost::asio::local::stream_protocol::socket socket, const std::shared_ptr<ServerShared>& shared);

}  // namespace markservo::mmi
