#pragma once

// A conversation by WebSocket, over any stream of Boost.Beast.

#include <boost/asio/steady_timer.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/http.hpp>
#include <boost/beast/websocket.hpp>
#include <chrono>
#include <exception>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "common/logging/log.hpp"
#include "services/mmi/server/connections_device.hpp"

namespace markservo::mmi {

// One read and at most one write are under way.
template <class Stream>
class SocketConnection final : public Registered, public std::enable_shared_from_this<SocketConnection<Stream>> {
 public:
  using Request = boost::beast::http::request<boost::beast::http::empty_body>;

  SocketConnection(Stream stream, std::shared_ptr<ServerShared> shared)
      : Registered(std::move(shared)),
        socket_(std::move(stream)),
        deadline_(socket_.get_executor()),
        conversation_(shared_->site.converse()) {}

  void accept(const Request& request) {
    lowest().expires_never();  // from now on the WebSocket has times of its own
    boost::beast::websocket::stream_base::timeout times{};
    times.handshake_timeout = duration_of(shared_->parameters.patience);
    times.idle_timeout = duration_of(shared_->parameters.longest_silence);
    times.keep_alive_pings = true;
    socket_.set_option(times);
    socket_.read_message_max(0);  // read() sees to it
    socket_.auto_fragment(false);
    socket_.async_accept(request, [self = this->shared_from_this()](ErrorCode error) {
      if (error) return self->count(error);
      self->accepted_ = true;
      self->expect_hello();
      self->read();
      self->wake();
    });
  }

  void wake() override {
    if (!accepted_ || writing_ || closing_) return;
    try {
      tell();
    } catch (const std::exception& error) {
      logging::error("a client is let go, for it cannot be told what to show: {}", error.what());
      end();
    }
  }

  bool converses() const override { return true; }

  std::optional<Time> idle_since() const override {
    const bool is_silent = std::chrono::steady_clock::now() - heard_ > duration_of(shared_->parameters.safe_silence);
    return is_silent ? std::optional<Time>(heard_) : std::nullopt;
  }

  void end() override {
    closing_ = true;
    deadline_.cancel();
    ErrorCode ignored;
    lowest().socket().close(ignored);
  }

 private:
  using ErrorCode = boost::beast::error_code;

  auto& lowest() { return boost::beast::get_lowest_layer(socket_); }

  void tell() {
    const std::string trouble = conversation_->trouble();
    if (!trouble.empty()) {
      ++shared_->refusals.behind;
      close(boost::beast::websocket::close_code::try_again_later, trouble);
      return;
    }
    std::optional<OutgoingMessage> message = conversation_->next();
    if (!message) return;
    writing_ = true;
    sent_ = std::move(message->data);
    socket_.binary(message->binary);
    socket_.async_write(boost::asio::const_buffer(sent_->data(), sent_->size()),
                        [self = this->shared_from_this()](ErrorCode error, std::size_t /*bytes*/) {
                          self->writing_ = false;
                          self->sent_.reset();
                          if (error) return self->end();
                          if (self->closing_) return self->send_close();
                          self->wake();
                        });
  }

  // A conversation that did not come about, or went on.
  void count(ErrorCode error) {
    const ErrorCode of_protocol = boost::beast::websocket::error::bad_opcode;
    if (error.category() == of_protocol.category() && error != boost::beast::websocket::error::closed) {
      ++shared_->refusals.malformed;
    }
    if (error == boost::beast::error::timeout) ++shared_->refusals.slow;
  }

  void expect_hello() {
    deadline_.expires_after(duration_of(shared_->parameters.patience));
    deadline_.async_wait([weak = this->weak_from_this()](ErrorCode error) {
      const auto self = weak.lock();
      if (error || !self || self->conversation_->greeted()) return;
      ++self->shared_->refusals.slow;
      self->end();
    });
  }

  void read() {
    // By pieces: what is too large is refused before it is here.
    const std::size_t room = shared_->parameters.largest_message + 1 - incoming_.size();
    socket_.async_read_some(incoming_, room, [self = this->shared_from_this()](ErrorCode error, std::size_t /*bytes*/) {
      if (error) {
        self->count(error);
        return self->end();
      }
      self->heard_ = std::chrono::steady_clock::now();
      const std::string refusal = self->take();
      if (!refusal.empty()) {
        ++self->shared_->refusals.malformed;
        return self->close(boost::beast::websocket::close_code::policy_error, refusal);
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
    const std::string text = boost::beast::buffers_to_string(incoming_.data());
    incoming_.consume(incoming_.size());
    return socket_.got_text() ? conversation_->hear(text) : "bytes; allowed: texts in JSON";
  }

  void close(boost::beast::websocket::close_code code, const std::string& why) {
    if (closing_) return;
    closing_ = true;
    constexpr std::size_t kLongestReason = 120;  // bytes; the protocol takes 123
    reason_ = boost::beast::websocket::close_reason(code, why.substr(0, kLongestReason));
    if (writing_) {
      // What cannot be written to the end is cut off.
      deadline_.expires_after(std::chrono::seconds(1));
      deadline_.async_wait([weak = this->weak_from_this()](ErrorCode error) {
        const auto self = weak.lock();
        if (!error && self) self->end();
      });
      return;
    }
    send_close();
  }

  void send_close() {
    socket_.async_close(reason_, [self = this->shared_from_this()](ErrorCode /*error*/) { self->end(); });
  }

  boost::beast::websocket::stream<Stream> socket_;
  boost::asio::steady_timer deadline_;
  std::unique_ptr<Conversation> conversation_;
  boost::beast::flat_buffer incoming_;
  std::shared_ptr<const std::string> sent_;  // what is under way
  boost::beast::websocket::close_reason reason_;
  Time heard_ = std::chrono::steady_clock::now();  // when it last said something
  bool accepted_ = false;
  bool writing_ = false;
  bool closing_ = false;
};

}  // namespace markservo::mmi
