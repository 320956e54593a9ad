#include "services/mmi/server/connections_device.hpp"

#include <boost/beast/core.hpp>
#include <boost/beast/http.hpp>
#include <boost/beast/websocket.hpp>
#include <chrono>
#include <optional>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

#include "services/mmi/server/socket_connection_device.hpp"

namespace markservo::mmi {
namespace {

namespace asio = boost::asio;
namespace beast = boost::beast;
namespace http = beast::http;
namespace websocket = beast::websocket;
using asio::local::stream_protocol;
using beast::error_code;

using TcpStream = beast::tcp_stream;
using LocalStream = beast::basic_stream<stream_protocol>;
using Request = http::request<http::empty_body>;

// An answer's bytes are shared with the site: a picture or the page is copied for nobody.
struct SharedBody {
  using value_type = std::shared_ptr<const std::string>;
  static std::uint64_t size(const value_type& body) { return body->size(); }

  class writer {
   public:
    using const_buffers_type = asio::const_buffer;
    template <bool kIsRequest, class Fields>
    writer(const http::header<kIsRequest, Fields>& /*header*/, const value_type& body) : body_(body) {}
    void init(error_code& error) { error = {}; }
    boost::optional<std::pair<const_buffers_type, bool>> get(error_code& error) {
      error = {};
      return {{const_buffers_type(body_->data(), body_->size()), false}};
    }

   private:
    const value_type& body_;
  };
};
using Response = http::response<SharedBody>;

RequestHead head_of(const Request& request, bool by_path) {
  RequestHead head;
  head.method = std::string(request.method_string());
  head.target = std::string(request.target());
  head.host = std::string(request[http::field::host]);
  const auto origin = request.find(http::field::origin);
  if (origin != request.end()) head.origin = std::string(origin->value());
  head.fetch_site = std::string(request["Sec-Fetch-Site"]);
  head.fetch_mode = std::string(request["Sec-Fetch-Mode"]);
  head.fetch_destination = std::string(request["Sec-Fetch-Dest"]);
  const beast::string_view authorization = request[http::field::authorization];
  constexpr const char* kBearer = "Bearer ";
  if (authorization.starts_with(kBearer)) {
    head.bearer = std::string(authorization.substr(beast::string_view(kBearer).size()));
  }
  head.upgrade = websocket::is_upgrade(request);
  head.by_path = by_path;
  return head;
}

// HTTP: one request after the other.
template <class Stream>
class RequestConnection final : public Registered, public std::enable_shared_from_this<RequestConnection<Stream>> {
 public:
  RequestConnection(Stream stream, std::shared_ptr<ServerShared> shared)
      : Registered(std::move(shared)), stream_(std::move(stream)), incoming_(shared_->parameters.largest_header) {}

  void read() {
    idle_since_ = std::chrono::steady_clock::now();
    parser_.emplace();
    parser_->header_limit(static_cast<std::uint32_t>(shared_->parameters.largest_header));
    parser_->body_limit(0U);
    stream_.expires_after(duration_of(shared_->parameters.patience));
    http::async_read(stream_, incoming_, *parser_,
                     [self = this->shared_from_this()](error_code error, std::size_t bytes) {
                       self->idle_since_.reset();
                       if (error) return self->give_up(error, bytes);
                       self->answer(self->parser_->release());
                     });
  }

  std::optional<Time> idle_since() const override { return idle_since_; }

  void end() override {
    error_code ignored;
    stream_.socket().close(ignored);
  }

 private:
  static constexpr bool kByPath = std::is_same_v<Stream, LocalStream>;

  void give_up(error_code error, std::size_t bytes) {
    const bool began = bytes > 0 || incoming_.size() > 0;
    if (error == beast::error::timeout) {
      if (began || !answered_) ++shared_->refusals.slow;
    } else if (error != http::error::end_of_stream &&
               error.category() == http::make_error_code(http::error::bad_method).category()) {
      ++shared_->refusals.malformed;
    }
    end();
  }

  void answer(Request request) {
    const RequestHead head = head_of(request, kByPath);
    if (head.upgrade) {
      const std::string refusal = shared_->site.refusal(head);
      if (!refusal.empty()) {
        ++shared_->refusals.requests;
        return refuse(request, 403, refusal);
      }
      // What is here already would be lost.
      if (incoming_.size() > 0) {
        ++shared_->refusals.malformed;
        return refuse(request, 400, "bytes behind a WebSocket's request; allowed: after its answer, 101");
      }
      std::make_shared<SocketConnection<Stream>>(std::move(stream_), shared_)->accept(request);
      return;
    }
    Answer answer = shared_->site.answer(head);
    if (answer.status == 403 || answer.status == 401) ++shared_->refusals.requests;
    send(request, std::move(answer));
  }

  void refuse(const Request& request, int status, const std::string& why) {
    send(request, {status, "text/plain; charset=utf-8", std::make_shared<std::string>(why + "\n")});
  }

  void send(const Request& request, Answer answer) {
    response_ = {};
    response_.version(request.version());
    response_.result(static_cast<unsigned>(answer.status));
    response_.set(http::field::content_type, answer.content_type);
    response_.set(http::field::cache_control, "no-store");
    response_.set("Content-Security-Policy", shared_->parameters.content_security_policy);
    response_.set("X-Content-Type-Options", "nosniff");
    response_.set("Referrer-Policy", "no-referrer");
    response_.set("Cross-Origin-Resource-Policy", "same-origin");
    response_.set("Cross-Origin-Opener-Policy", "same-origin");
    response_.keep_alive(request.keep_alive() && answer.status == 200);
    response_.body() = answer.body ? std::move(answer.body) : std::make_shared<std::string>();
    response_.content_length(response_.body()->size());
    if (request.method() == http::verb::head) response_.body() = std::make_shared<std::string>();
    serializer_.emplace(response_);
    write();
  }

  // By pieces: who takes some of it in time is given time for the rest.
  void write() {
    stream_.expires_after(duration_of(shared_->parameters.patience));
    http::async_write_some(stream_, *serializer_,
                           [self = this->shared_from_this()](error_code error, std::size_t /*bytes*/) {
                             if (!error && !self->serializer_->is_done()) return self->write();
                             self->answered_ = true;
                             if (error == beast::error::timeout) ++self->shared_->refusals.slow;
                             if (error || !self->response_.keep_alive()) return self->finish();
                             self->read();
                           });
  }

  void finish() {
    error_code ignored;
    stream_.socket().shutdown(asio::socket_base::shutdown_send, ignored);
    end();
  }

  Stream stream_;
  beast::flat_buffer incoming_;
  std::optional<http::request_parser<http::empty_body>> parser_;
  Response response_;
  std::optional<http::response_serializer<SharedBody>> serializer_;
  std::optional<Time> idle_since_;  // while it waits for a request
  bool answered_ = false;
};

template <class Stream, class Socket>
void serve(Socket socket, const std::shared_ptr<ServerShared>& shared) {
  if (shared->ended || !shared->make_room()) {
    error_code ignored;
    socket.close(ignored);
    return;
  }
  std::make_shared<RequestConnection<Stream>>(Stream(std::move(socket)), shared)->read();
}

}  // namespace

std::chrono::steady_clock::duration duration_of(double seconds) {
  return std::chrono::duration_cast<std::chrono::steady_clock::duration>(std::chrono::duration<double>(seconds));
}

void ServerShared::wake() {
  const std::vector<Connection*> now(connections.begin(), connections.end());
  for (Connection* connection : now) {
    if (connections.count(connection) != 0) connection->wake();
  }
}

bool ServerShared::make_room() {
  if (static_cast<int>(connections.size()) < parameters.most_clients) return true;
  ++refusals.connections;
  Connection* longest = nullptr;
  std::tuple<bool, Connection::Time> its_turn;
  for (Connection* connection : connections) {
    const std::optional<Connection::Time> since = connection->idle_since();
    if (!since) continue;
    const std::tuple<bool, Connection::Time> turn{connection->converses(), *since};
    if (longest != nullptr && its_turn <= turn) continue;
    longest = connection;
    its_turn = turn;
  }
  if (longest == nullptr) return false;
  connections.erase(longest);
  longest->end();
  return true;
}

void ServerShared::end() {
  ended = true;
  const std::vector<Connection*> now(connections.begin(), connections.end());
  for (Connection* connection : now) {
    if (connections.count(connection) != 0) connection->end();
  }
}

void serve_connection(asio::ip::tcp::socket socket, const std::shared_ptr<ServerShared>& shared) {
  error_code ignored;
  socket.set_option(asio::ip::tcp::no_delay(true), ignored);
  serve<TcpStream>(std::move(socket), shared);
}

void serve_connection(stream_protocol::socket socket, const std::shared_ptr<ServerShared>& shared) {
  serve<LocalStream>(std::move(socket), shared);
}

}  // namespace markservo::mmi
