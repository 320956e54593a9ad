#pragma once

// The connections of server_device, over any stream of Boost.Beast.

#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/local/stream_protocol.hpp>
#include <boost/asio/steady_timer.hpp>
#include <memory>
#include <set>

#include "services/mmi/server/server_device.hpp"

namespace markservo::mmi {

class Connection {
 public:
  virtual ~Connection() = default;
  virtual void wake() {}
  virtual bool converses() const { return false; }
  virtual void end() = 0;
};

// What all connections of a server share. Each is in `connections` for as long as it lives.
struct ServerShared {
  ServerShared(ServerParameters its_parameters, WebSite& its_site)
      : parameters(std::move(its_parameters)), site(its_site) {}

  // A connection may end, and leave, while it is woken or ended.
  void wake();
  void end();

  ServerParameters parameters;
  WebSite& site;
  Refusals refusals;
  std::set<Connection*> connections;
  bool ended = false;
};

// Reads requests from `socket` and answers them until it ends; closes it at once when there are too many.
void serve_connection(boost::asio::ip::tcp::socket socket, const std::shared_ptr<ServerShared>& shared);
void serve_connection(boost::asio::local::stream_protocol::socket socket, const std::shared_ptr<ServerShared>& shared);

}  // namespace markservo::mmi
