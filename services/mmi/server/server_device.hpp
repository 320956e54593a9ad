#pragma once

// A small web server: HTTP and WebSocket over TCP or a socket with a path, by Boost.Beast, in the caller's thread.

#include <functional>
#include <memory>
#include <string>

#include "services/mmi/server/web_site.hpp"

namespace boost::asio {
class io_context;
}

namespace markservo::mmi {

// Where to listen: an address with a port, or a path.
struct ListenPlace {
  std::string address;  // "127.0.0.1", "::1"; empty: `path`
  int port = 0;
  std::string path;

  bool is_path() const { return address.empty(); }
};

struct ServerParameters {
  int most_clients = 64;                // connections at once; then one more takes the place of the longest idle
  std::size_t largest_header = 8192;    // bytes: a browser's has about 1,000
  std::size_t largest_message = 65536;  // bytes, of a client
  double patience = 10.0;               // s, to say what is wanted, or to take some more of an answer
  double safe_silence = 20.0;      // s: a page says several times a second what it has taken in. Who has said nothing
                                   // for so long keeps its place only while there are others
  double longest_silence = 120.0;  // s without a word, not even an answer to a ping, after which a WebSocket is
                                   // ended: who does not read for a minute is behind, not gone
  std::string content_security_policy;
};

class Server {
 public:
  // Listens from now on. `site` must outlive this. Throws ConfigurationError: the place is taken, or not this host's.
  Server(boost::asio::io_context& io, const ListenPlace& place, ServerParameters parameters, WebSite& site);
  ~Server();
  Server(const Server&) = delete;
  Server& operator=(const Server&) = delete;

  // Asks every conversation whose last message is out whether there is another.
  void wake();
  const Refusals& refusals() const;
  // Connections now; those of them that are WebSockets.
  int connections() const;
  int conversations() const;

 private:
  struct State;
  std::shared_ptr<State> state_;
};

}  // namespace markservo::mmi
