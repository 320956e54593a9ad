#include "services/mmi/server/server_device.hpp"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <boost/asio/io_context.hpp>
#include <boost/asio/local/stream_protocol.hpp>
#include <chrono>
#include <deque>
#include <list>

#include "common/robot/configuration_error.hpp"
#include "tests/unit/mmi/web_peer.hpp"
#include "tests/unit/temporary_folder.hpp"

namespace markservo::mmi {
namespace {

// Answers "hello" to /, refuses foreign origins; says back what it hears, and what the test wants said.
class SaysBack final : public WebSite {
 public:
  class Talk final : public Conversation {
   public:
    explicit Talk(SaysBack& site) : site_(site) {}
    std::string hear(std::string_view text) override {
      greeted_ = true;
      if (text == "nonsense") return "nonsense; allowed: sense";
      waiting_.emplace_back(text);
      return {};
    }
    bool greeted() const override { return greeted_; }
    std::optional<OutgoingMessage> next() override {
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
    bool greeted_ = false;
  };

  Answer answer(const RequestHead& request) override {
    last = request;
    if (request.target != "/") return {404, "text/plain", std::make_shared<const std::string>("nothing here")};
    return {200, "text/plain", std::make_shared<const std::string>("hello")};
  }
  std::string refusal(const RequestHead& request) const override {
    return request.origin.value_or("") == "http://localhost" ? "" : "a foreign origin";
  }
  std::unique_ptr<Conversation> converse() override { return std::make_unique<Talk>(*this); }

  RequestHead last;
  std::shared_ptr<const std::string> flood;
  std::string trouble;
};

class WebServer : public ::testing::Test {
 protected:
  WebServer() {
    parameters_.most_clients = 8;
    parameters_.patience = 0.2;
    parameters_.content_security_policy = "default-src 'none'";
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
      for (WebPeer& one : peers_) one.receive();
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

  boost::asio::io_context io_;
  test::TemporaryFolder folder_;
  std::string path_ = folder_.file("socket");
  ServerParameters parameters_;
  SaysBack site_;
  std::unique_ptr<Server> server_;
  std::list<WebPeer> peers_;
};

TEST_F(WebServer, AnswersRequestAfterRequest) {
  WebPeer& one = peer();
  one.get("/");
  ASSERT_TRUE(answers(one, "hello"));
  EXPECT_NE(one.received().find("Content-Security-Policy: default-src 'none'"), std::string::npos);
  EXPECT_NE(one.received().find("X-Content-Type-Options: nosniff"), std::string::npos);
  one.forget();
  one.get("/other");
  EXPECT_TRUE(answers(one, "404"));
  EXPECT_TRUE(site_.last.by_path);
}

TEST_F(WebServer, TellsTheSiteWhatDecides) {
  WebPeer& one = peer();
  one.get("/?x=1", "robot.lab:80", "Origin: http://a\r\nSec-Fetch-Site: cross-site\r\nAuthorization: Bearer abc\r\n");
  ASSERT_TRUE(answers(one, "404"));
  EXPECT_EQ(site_.last.host, "robot.lab:80");
  EXPECT_EQ(site_.last.target, "/?x=1");
  EXPECT_EQ(site_.last.origin, "http://a");
  EXPECT_EQ(site_.last.fetch_site, "cross-site");
  EXPECT_EQ(site_.last.bearer, "abc");
}

TEST_F(WebServer, ConversesByWebSocket) {
  WebPeer& one = peer();
  one.open_socket();
  ASSERT_TRUE(answers(one, "101 Switching Protocols"));
  one.say("good morning");
  EXPECT_TRUE(answers(one, "good morning"));
  EXPECT_EQ(server_->conversations(), 1);
}

TEST_F(WebServer, OpensNoWebSocketThatTheSiteRefuses) {
  WebPeer& one = peer();
  one.open_socket("http://evil.example");
  EXPECT_TRUE(answers(one, "403"));
  EXPECT_TRUE(answers(one, "a foreign origin"));
  EXPECT_EQ(server_->refusals().requests, 1);
}

TEST_F(WebServer, EndsAConversationThatMakesNoSense) {
  WebPeer& one = peer();
  one.open_socket();
  ASSERT_TRUE(answers(one, "101"));
  one.say("nonsense");
  EXPECT_TRUE(answers(one, "allowed: sense"));
  EXPECT_TRUE(ends(one));
  EXPECT_EQ(server_->refusals().malformed, 1);
}

TEST_F(WebServer, LetsGoWhoFallsBehind) {
  WebPeer& one = peer();
  one.open_socket();
  ASSERT_TRUE(answers(one, "101"));
  one.say("hello");
  ASSERT_TRUE(answers(one, "hello"));
  site_.trouble = "too slow";
  EXPECT_TRUE(answers(one, "too slow"));
  EXPECT_TRUE(ends(one));
  EXPECT_EQ(server_->refusals().behind, 1);
}

TEST_F(WebServer, WaitsForNobodyWhoDoesNotSpeak) {
  WebPeer& silent = peer();
  WebPeer& slow = peer();
  slow.send("GET / HT");
  WebPeer& mute = peer();
  mute.open_socket();
  EXPECT_TRUE(ends(silent));
  EXPECT_TRUE(ends(slow));
  EXPECT_TRUE(ends(mute));
  EXPECT_EQ(server_->refusals().slow, 3);
  EXPECT_TRUE(until([&] { return server_->connections() == 0; }));
}

TEST_F(WebServer, RefusesWhatIsTooLargeOrNoHttp) {
  WebPeer& large = peer();
  large.get("/", "localhost", "X: " + std::string(9000, 'x') + "\r\n");
  WebPeer& foreign = peer();
  foreign.send("\x16\x03\x01\x02 what TLS begins with\r\n\r\n");
  WebPeer& with_body = peer();
  with_body.send("POST / HTTP/1.1\r\nHost: localhost\r\nContent-Length: 5\r\n\r\nhello");
  EXPECT_TRUE(ends(large));
  EXPECT_TRUE(ends(foreign));
  EXPECT_TRUE(ends(with_body));
  EXPECT_EQ(server_->refusals().malformed, 3);
}

TEST_F(WebServer, EndsAConversationWithAMessageThatIsTooLarge) {
  WebPeer& one = peer();
  one.open_socket();
  ASSERT_TRUE(answers(one, "101"));
  // Says that a gigabyte follows, and begins with it.
  one.send(std::string("\x81\xff\0\0\0\0\x40\0\0\0\0\0\0\0", 14) + std::string(70000, 'x'));
  EXPECT_TRUE(answers(one, "65536 bytes"));
  EXPECT_TRUE(ends(one));
  EXPECT_EQ(server_->refusals().malformed, 1);
}

TEST_F(WebServer, TakesSoManyConnectionsAndNoMore) {
  for (int i = 0; i < parameters_.most_clients; ++i) peer().get("/");
  for (WebPeer& one : peers_) ASSERT_TRUE(answers(one, "hello"));
  WebPeer& late = peer();
  late.get("/");
  EXPECT_TRUE(ends(late));
  EXPECT_EQ(server_->refusals().connections, 1);
  EXPECT_EQ(late.received(), "");
}

TEST_F(WebServer, IsHeldUpByNobodyWhoDoesNotRead) {
  site_.flood = std::make_shared<const std::string>(1 << 20, 'x');
  WebPeer& stalled = peers_.emplace_back(path_);
  stalled.open_socket();
  stalled.say("hello");
  until([&] { return server_->conversations() == 1; });
  std::list<WebPeer> others;
  std::swap(others, peers_);  // nobody reads for it
  WebPeer& quick = peer();
  quick.get("/");
  EXPECT_TRUE(answers(quick, "hello"));
}

TEST_F(WebServer, ListensForItsOwnerAlone) {
  struct stat found {};
  ASSERT_EQ(::stat(path_.c_str(), &found), 0);
  EXPECT_EQ(found.st_mode & 0077U, 0U);
}

TEST_F(WebServer, ListensNowhereTwice) {
  EXPECT_THROW(Server(io_, ListenPlace{"", 0, path_}, parameters_, site_), ConfigurationError);
  EXPECT_THROW(Server(io_, ListenPlace{"", 0, folder_.write("file", "")}, parameters_, site_), ConfigurationError);
  EXPECT_THROW(Server(io_, ListenPlace{"", 0, folder_.file("none/socket")}, parameters_, site_), ConfigurationError);
}

TEST_F(WebServer, TakesThePlaceOfOneThatWasKilled) {
  const std::string left = folder_.file("left");
  { boost::asio::local::stream_protocol::acceptor dead(io_, boost::asio::local::stream_protocol::endpoint(left)); }
  const Server server(io_, ListenPlace{"", 0, left}, parameters_, site_);
  EXPECT_NO_THROW(WebPeer{left});
}

TEST_F(WebServer, LeavesNothingWhenItEnds) {
  WebPeer& one = peer();
  one.open_socket();
  ASSERT_TRUE(answers(one, "101"));
  server_.reset();
  struct stat found {};
  EXPECT_NE(::stat(path_.c_str(), &found), 0);
  io_.restart();
  io_.run_for(std::chrono::milliseconds(10));
  one.receive();
  EXPECT_TRUE(one.ended());
}

}  // namespace
}  // namespace markservo::mmi
