#pragma once

// A web server in the test's thread, and clients of it.

#include <gtest/gtest.h>

#include <boost/asio/io_context.hpp>
#include <chrono>
#include <cstdint>
#include <deque>
#include <functional>
#include <list>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>

#include "services/mmi/server/server_device.hpp"
#include "tests/unit/mmi/web_peer.hpp"
#include "tests/unit/temporary_folder.hpp"

namespace markservo::mmi {

// Answers "hello" to / and 3 MB to /large, refuses foreign origins; says back what it hears, and what the test wants
// said.
class SaysBack final : public WebSite {
 public:
  class Talk final : public Conversation {
   public:
    explicit Talk(SaysBack& site) : site_(site) {}
    std::string hear(std::string_view text) override {
      greeted_ = true;
      if (text == "nonsense") return "nonsense; allowed: sense";
      said_last_ = text;
      waiting_.emplace_back(text);
      return {};
    }
    bool greeted() const override { return greeted_; }
    std::optional<OutgoingMessage> next() override {
      if (said_last_ == "throw") throw std::runtime_error("nothing to say");
      if (site_.flood && greeted_) return OutgoingMessage{site_.flood, true};
      if (waiting_.empty()) return std::nullopt;
      OutgoingMessage message{std::make_shared<const std::string>(waiting_.front()), false};
      waiting_.pop_front();
      return message;
    }
    std::string trouble() const override { return site_.trouble; }

   private:
    SaysBack& site_;
    std::deque<std::string> waiting_;
    std::string said_last_;
    bool greeted_ = false;
  };

  Answer answer(const RequestHead& request) override {
    last = request;
    if (request.target == "/large") return {200, "text/plain", large};
    if (request.target != "/") return {404, "text/plain", std::make_shared<const std::string>("nothing here")};
    return {200, "text/plain", std::make_shared<const std::string>("hello")};
  }
  std::string refusal(const RequestHead& request) const override {
    return request.origin.value_or("") == "http://localhost" ? "" : "a foreign origin";
  }
  std::unique_ptr<Conversation> converse() override { return std::make_unique<Talk>(*this); }

  RequestHead last;
  std::shared_ptr<const std::string> flood;
  std::shared_ptr<const std::string> large = std::make_shared<const std::string>(3 << 20, 'x');  // at /large
  std::string trouble;
};

class WebServer : public ::testing::Test {
 protected:
  WebServer() {
    parameters_.most_clients = 8;
    parameters_.patience = 0.2;
    parameters_.content_security_policy = "default-src 'none'";
    begin();
  }

  // A server by what parameters_ are now.
  void begin() {
    server_.reset();
    server_ = std::make_unique<Server>(io_, ListenPlace{"", 0, path_}, parameters_, site_);
  }

  WebPeer& peer() { return peers_.emplace_back(path_); }

  // Runs the server, and lets all receive, until `holds`; false if it never does.
  bool until(const std::function<bool()>& holds) {
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(20);
    while (std::chrono::steady_clock::now() < end) {
      io_.restart();
      io_.run_for(std::chrono::milliseconds(1));
      server_->wake();
      for (WebPeer& one : peers_) one.receive(most_received_);
      if (holds()) return true;
    }
    return false;
  }
  bool answers(WebPeer& peer, const std::string& text) {
    return until([&] { return peer.received().find(text) != std::string::npos; });
  }
  bool ends(WebPeer& peer) {
    return until([&] { return peer.ended(); });
  }
  // A peer whose WebSocket is open and that says `text`.
  WebPeer& talker(const std::string& text = "hello") {
    WebPeer& one = peer();
    one.open_socket();
    EXPECT_TRUE(answers(one, "101"));
    one.say(text);
    return one;
  }

  boost::asio::io_context io_;
  test::TemporaryFolder folder_;
  std::string path_ = folder_.file("socket");
  ServerParameters parameters_;
  SaysBack site_;
  std::unique_ptr<Server> server_;
  std::list<WebPeer> peers_;
  std::size_t most_received_ = SIZE_MAX;  // bytes, of each peer at a turn
};

}  // namespace markservo::mmi
