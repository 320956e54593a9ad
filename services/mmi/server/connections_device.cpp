#include "services/mmi/server/connections_device.hpp"

#include <boost/beast/core.hpp>
#include <boost/beast/http.hpp>
#include <boost/beast/websocket.hpp>
#include <chrono>
#include <optional>
#include <type_traits>
#include <vector>

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

std::chrono::steady_clock::duration seconds(double value) {
  return std::chrono::duration_cast<std::chrono::steady_clock::duration>(std::chrono::duration<double>(value));
}

RequestHead head_of(const Request& request, bool by_path) {
  RequestHead head;
  head.method = std::string(request.method_string());
  head.target = std::string(request.target());
  head.host = std::string(request[http::field::host]);
  const auto origin = request.find(http::field::origin);
  if (origin != request.end()) head.origin = std::string(origin->value());
  head.fetch_site = std::string(request["Sec-Fetch-Site"]);
  const beast::string_view authorization = request[http::field::authorization];
  constexpr const char* kBearer = "Bearer ";
  if (authorization.starts_with(kBearer)) {
    head.bearer = std::string(authorization.substr(beast::string_view(kBearer).size()));
  }
  head.upgrade = websocket::is_upgrade(request);
  head.by_path = by_path;
  return head;
}

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

// A WebSocket: one read and at most one write are under way.
template <class Stream>
class SocketConnection final : public Registered, public std::enable_shared_from_this<SocketConnection<Stream>> {
 public:
  SocketConnection(Stream stream, std::shared_ptr<ServerShared> shared)
      : Registered(std::move(shared)),
        socket_(std::move(stream)),
        deadline_(socket_.get_executor()),
        conversation_(shared_->site.converse()) {}

  void accept(const Request& request) {
    beast::get_lowest_layer(socket_).expires_never();  // from now on the WebSocket has times of its own
    auto times = websocket::stream_base::timeout::suggested(beast::role_type::server);
    times.handshake_timeout = seconds(shared_->parameters.patience);
    times.keep_alive_pings = true;
    socket_.set_option(times);
    socket_.read_message_max(0);  // read() sees to it
    socket_.auto_fragment(false);
    socket_.async_accept(request, [self = this->shared_from_this()](error_code error) {
      if (error) return;
      self->accepted_ = true;
      self->expect_hello();
      self->read();
      self->wake();
    });
  }

  void wake() override {
    if (!accepted_ || writing_ || closing_) return;
    const std::string trouble = conversation_->trouble();
    if (!trouble.empty()) {
      ++shared_->refusals.behind;
      close(websocket::close_code::try_again_later, trouble);
      return;
    }
    std::optional<OutgoingMessage> message = conversation_->next();
    if (!message) return;
    writing_ = true;
    sent_ = std::move(message->data);
    socket_.binary(message->binary);
    socket_.async_write(asio::const_buffer(sent_->data(), sent_->size()),
                        [self = this->shared_from_this()](error_code error, std::size_t /*bytes*/) {
                          self->writing_ = false;
                          self->sent_.reset();
                          if (error) return self->end();
                          if (self->closing_) return self->send_close();
                          self->wake();
                        });
  }

  bool converses() const override { return true; }

  void end() override {
    closing_ = true;
    deadline_.cancel();
    error_code ignored;
    beast::get_lowest_layer(socket_).socket().close(ignored);
  }

 private:
  void expect_hello() {
    deadline_.expires_after(seconds(shared_->parameters.patience));
    deadline_.async_wait([weak = this->weak_from_this()](error_code error) {
      const auto self = weak.lock();
      if (error || !self || self->conversation_->greeted()) return;
      ++self->shared_->refusals.slow;
      self->end();
    });
  }

  void read() {
    // By pieces: what is too large is refused before it is here.
    const std::size_t room = shared_->parameters.largest_message + 1 - incoming_.size();
    socket_.async_read_some(
        incoming_, room, [self = this->shared_from_this()](error_code error, std::size_t /*bytes*/) {
          if (error) {
            const bool is_of_protocol = error.category() == error_code(websocket::error::bad_opcode).category();
            if (is_of_protocol && error != websocket::error::closed) ++self->shared_->refusals.malformed;
            return self->end();
          }
          const std::string refusal = self->take();
          if (!refusal.empty()) {
            ++self->shared_->refusals.malformed;
            return self->close(websocket::close_code::policy_error, refusal);
          }
          self->wake();
          if (!self->closing_) self->read();
        });
  }

  // Takes what has been read. Why it is refused; empty while all is well.
  std::string take() {
    const std::size_t largest = shared_->parameters.largest_message;
    if (incoming_.size() > largest) return "a message above " + std::to_string(largest) + " bytes";
    if (!socket_.is_message_done()) return {};
    const std::string text = beast::buffers_to_string(incoming_.data());
    incoming_.consume(incoming_.size());
    return socket_.got_text() ? conversation_->hear(text) : "bytes; allowed: texts in JSON";
  }

  void close(websocket::close_code code, const std::string& why) {
    if (closing_) return;
    closing_ = true;
    constexpr std::size_t kLongestReason = 120;  // bytes; the protocol takes 123
    reason_ = websocket::close_reason(code, why.substr(0, kLongestReason));
    if (writing_) {
      // What cannot be written to the end is cut off.
      deadline_.expires_after(std::chrono::seconds(1));
      deadline_.async_wait([weak = this->weak_from_this()](error_code error) {
        const auto self = weak.lock();
        if (!error && self) self->end();
      });
      return;
    }
    send_close();
  }

  void send_close() {
    socket_.async_close(reason_, [self = this->shared_from_this()](error_code /*error*/) { self->end(); });
  }

  websocket::stream<Stream> socket_;
  asio::steady_timer deadline_;
  std::unique_ptr<Conversation> conversation_;
  beast::flat_buffer incoming_;
  std::shared_ptr<const std::string> sent_;  // what is under way
  websocket::close_reason reason_;
  bool accepted_ = false;
  bool writing_ = false;
  bool closing_ = false;
};

// HTTP: one request after the other.
template <class Stream>
class RequestConnection final : public Registered, public std::enable_shared_from_this<RequestConnection<Stream>> {
 public:
  RequestConnection(Stream stream, std::shared_ptr<ServerShared> shared)
      : Registered(std::move(shared)), stream_(std::move(stream)), incoming_(shared_->parameters.largest_header) {}

  void read() {
    parser_.emplace();
    parser_->header_limit(static_cast<std::uint32_t>(shared_->parameters.largest_header));
    parser_->body_limit(0U);
    stream_.expires_after(seconds(shared_->parameters.patience));
    http::async_read(stream_, incoming_, *parser_,
                     [self = this->shared_from_this()](error_code error, std::size_t bytes) {
                       if (error) return self->give_up(error, bytes);
                       self->answer(self->parser_->release());
                     });
  }

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
        return send(request, {403, "text/plain; charset=utf-8", std::make_shared<std::string>(refusal + "\n")});
      }
      std::make_shared<SocketConnection<Stream>>(std::move(stream_), shared_)->accept(request);
      return;
    }
    Answer answer = shared_->site.answer(head);
    if (answer.status == 403 || answer.status == 401) ++shared_->refusals.requests;
    send(request, std::move(answer));
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
    stream_.expires_after(seconds(shared_->parameters.patience));
    http::async_write(stream_, response_, [self = this->shared_from_this()](error_code error, std::size_t /*bytes*/) {
      self->answered_ = true;
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
  bool answered_ = false;
};

template <class Stream, class Socket>
void serve(Socket socket, const std::shared_ptr<ServerShared>& shared) {
  if (shared->ended || static_cast<int>(shared->connections.size()) >= shared->parameters.most_clients) {
    ++shared->refusals.connections;
    error_code ignored;
    socket.close(ignored);
    return;
  }
  std::make_shared<RequestConnection<Stream>>(Stream(std::move(socket)), shared)->read();
}

}  // namespace

void ServerShared::wake() {
  const std::vector<Connection*> now(connections.begin(), connections.end());
  for (Connection* connection : now) {
    if (connections.count(connection) != 0) connection->wake();
  }
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
