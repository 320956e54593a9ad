#include "services/mmi/server/server_device.hpp"

#include <gtest/gtest.h>

#include <chrono>

#include "tests/unit/mmi/web_server.hpp"

namespace markservo::mmi {
namespace {

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

TEST_F(WebServer, AnswersHeadByWhatGetWouldHaveAndNoBody) {
  WebPeer& one = peer();
  one.send("HEAD / HTTP/1.1\r\nHost: localhost\r\n\r\n");
  ASSERT_TRUE(answers(one, "\r\n\r\n"));
  EXPECT_NE(one.received().find("Content-Length: 5\r\n"), std::string::npos);
  one.forget();
  one.get("/");
  ASSERT_TRUE(answers(one, "hello"));
  EXPECT_EQ(one.received().substr(0, 12), "HTTP/1.1 200");
}

TEST_F(WebServer, AnswersRequestsThatComeAtOnceOneAfterTheOther) {
  WebPeer& one = peer();
  const std::string get = "GET / HTTP/1.1\r\nHost: localhost\r\n\r\n";
  one.send(get + get + "GET /other HTTP/1.1\r\nHost: localhost\r\n\r\n");
  ASSERT_TRUE(answers(one, "nothing here"));
  const std::size_t first = one.received().find("hello");
  ASSERT_NE(first, std::string::npos);
  EXPECT_NE(one.received().find("hello", first + 1), std::string::npos);
}

TEST_F(WebServer, OpensNoWebSocketBeforeWhoseAnswerMoreIsSaid) {
  WebPeer& one = peer();
  one.send(WebPeer::socket_request() + "\x81\x82xxxx");
  EXPECT_TRUE(answers(one, "400"));
  EXPECT_TRUE(answers(one, "bytes behind a WebSocket's request"));
  EXPECT_TRUE(ends(one));
  EXPECT_EQ(server_->refusals().malformed, 1);
}

TEST_F(WebServer, CountsAHandshakeThatIsNone) {
  WebPeer& one = peer();
  one.get("/socket", "localhost",
          "Origin: http://localhost\r\nUpgrade: websocket\r\nConnection: Upgrade\r\nSec-WebSocket-Version: 7\r\n"
          "Sec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\n");
  EXPECT_TRUE(answers(one, "426"));
  EXPECT_TRUE(ends(one));
  EXPECT_EQ(server_->refusals().malformed, 1);
}

TEST_F(WebServer, LetsGoOfWhoCannotBeToldAndOfNobodyElse) {
  WebPeer& other = talker("good morning");
  ASSERT_TRUE(answers(other, "good morning"));
  WebPeer& one = talker("throw");
  EXPECT_TRUE(until([&] { return one.ended(); }));
  other.say("good evening");
  EXPECT_TRUE(answers(other, "good evening"));
}

}  // namespace
}  // namespace markservo::mmi
