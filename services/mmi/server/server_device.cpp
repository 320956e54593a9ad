#include "services/mmi/server/server_device.hpp"

#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

#include <algorithm>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/local/stream_protocol.hpp>
#include <boost/asio/steady_timer.hpp>
#include <cerrno>
#include <chrono>
#include <memory>
#include <optional>
#include <string>
#include <system_error>
#include <utility>

#include "common/robot/configuration_error.hpp"
#include "services/mmi/server/connections_device.hpp"

namespace markservo::mmi {
namespace {

namespace asio = boost::asio;
using boost::system::error_code;

// Accepts for as long as the server lives; beyond the most connections, it takes and closes them.
template <class Protocol>
class Door final : public std::enable_shared_from_this<Door<Protocol>> {
 public:
  Door(asio::io_context& io, const typename Protocol::endpoint& place, std::shared_ptr<ServerShared> shared)
      : acceptor_(io), retry_(io), shared_(std::move(shared)) {
    acceptor_.open(place.protocol());
    if constexpr (std::is_same_v<Protocol, asio::ip::tcp>) {
      acceptor_.set_option(asio::socket_base::reuse_address(true));
    }
    acceptor_.bind(place);
    acceptor_.listen();
  }

  void open() {
    acceptor_.async_accept([self = this->shared_from_this()](error_code error, typename Protocol::socket socket) {
      if (error == asio::error::operation_aborted) return;
      if (!error) {
        self->open();  // first: what one connection throws must not close the door
        serve_connection(std::move(socket), self->shared_);
        return;
      }
      // No descriptor is left, for instance: connections that end give theirs back.
      self->retry_.expires_after(kRetry);
      self->retry_.async_wait([self](error_code ended) {
        if (!ended) self->open();
      });
    });
  }

  void close() {
    error_code ignored;
    acceptor_.close(ignored);
    retry_.cancel();
  }

 private:
  static constexpr std::chrono::milliseconds kRetry{100};

  typename Protocol::acceptor acceptor_;
  asio::steady_timer retry_;
  std::shared_ptr<ServerShared> shared_;
};

// The error of a connection to `path`; 0: somebody listens. Waits for nobody: a listener that is busy has EAGAIN.
int knock(const std::string& path) {
  const int knocking = ::socket(AF_UNIX, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0);
  if (knocking < 0) return errno;
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  path.copy(address.sun_path, sizeof address.sun_path - 1);
  const bool connected = ::connect(knocking, reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0;
  const int error = connected ? 0 : errno;
  ::close(knocking);
  return error;
}

// A socket that nobody listens at any more, of a program that was killed, is in the way of the next.
void remove_dead_socket(const std::string& path) {
  struct stat found {};
  if (::lstat(path.c_str(), &found) != 0) return;
  if (!S_ISSOCK(found.st_mode)) throw ConfigurationError("--listen " + path + ": is no socket; allowed: a new path");
  const int error = knock(path);
  if (error == ECONNREFUSED) {
    ::unlink(path.c_str());
  } else if (error == 0 || error == EAGAIN) {
    throw ConfigurationError("--listen " + path + ": somebody listens there already; allowed: another path");
  } else {
    throw ConfigurationError("--listen " + path + ": a socket is there, of which nobody knows whether it is in use: " +
                             std::generic_category().message(error) + "; allowed: another path");
  }
}

// The socket that a server made, as long as it is there: its path may be another's by then.
class OwnSocket {
 public:
  explicit OwnSocket(std::string path) : path_(std::move(path)) { is_made_ = ::lstat(path_.c_str(), &made_) == 0; }
  ~OwnSocket() {
    struct stat found {};
    const bool is_there = is_made_ && ::lstat(path_.c_str(), &found) == 0;
    if (is_there && found.st_dev == made_.st_dev && found.st_ino == made_.st_ino) ::unlink(path_.c_str());
  }
  OwnSocket(const OwnSocket&) = delete;
  OwnSocket& operator=(const OwnSocket&) = delete;

 private:
  std::string path_;
  struct stat made_ {};
  bool is_made_ = false;
};

}  // namespace

struct Server::State {
  std::shared_ptr<ServerShared> shared;
  std::shared_ptr<Door<asio::ip::tcp>> tcp;
  std::shared_ptr<Door<asio::local::stream_protocol>> local;
  std::optional<OwnSocket> own;
};

Server::Server(asio::io_context& io, const ListenPlace& place, ServerParameters parameters, WebSite& site)
    : state_(std::make_shared<State>()) {
  state_->shared = std::make_shared<ServerShared>(std::move(parameters), site);
  try {
    if (place.is_path()) {
      remove_dead_socket(place.path);
      const ::mode_t before = ::umask(0077);  // for its owner alone, from its first moment
      const auto restore = std::unique_ptr<const ::mode_t, void (*)(const ::mode_t*)>(
          &before, [](const ::mode_t* mask) { ::umask(*mask); });
      state_->local = std::make_shared<Door<asio::local::stream_protocol>>(
          io, asio::local::stream_protocol::endpoint(place.path), state_->shared);
      state_->own.emplace(place.path);
      state_->local->open();
      return;
    }
    const auto address = asio::ip::make_address(place.address);
    state_->tcp = std::make_shared<Door<asio::ip::tcp>>(
        io, asio::ip::tcp::endpoint(address, static_cast<std::uint16_t>(place.port)), state_->shared);
    state_->tcp->open();
  } catch (const boost::system::system_error& error) {
    const std::string where = place.is_path() ? place.path : place.address + ":" + std::to_string(place.port);
    throw ConfigurationError("--listen " + where + ": " + error.code().message() +
                             "; allowed: a free port of this host, or a new path in a folder of yours");
  }
}

Server::~Server() {
  state_->own.reset();  // while it listens: later the path may be another's, who found nobody there
  if (state_->tcp) state_->tcp->close();
  if (state_->local) state_->local->close();
  state_->shared->end();
}

void Server::wake() {
  state_->shared->wake();
}

const Refusals& Server::refusals() const {
  return state_->shared->refusals;
}

int Server::connections() const {
  return static_cast<int>(state_->shared->connections.size());
}

int Server::conversations() const {
  const auto& all = state_->shared->connections;
  return static_cast<int>(std::count_if(all.begin(), all.end(), [](const auto* one) { return one->converses(); }));
}

}  // namespace markservo::mmi
