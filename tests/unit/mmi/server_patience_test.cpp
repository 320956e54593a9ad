// How long, and to how many, a web server gives its time and places.

#include <gtest/gtest.h>

#include <chrono>
#include <thread>

#include "tests/unit/mmi/web_server.hpp"

namespace markservo::mmi {
namespace {

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

TEST_F(WebServer, GivesALargeAnswerToWhoTakesItSlowlyButSteadily) {
  parameters_.patience = 0.5;
  begin();
  WebPeer& slow = peer();
  slow.get("/large");
  most_received_ = 65536;
  const auto begun = std::chrono::steady_clock::now();
  ASSERT_TRUE(until([&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(15));
    return slow.received().size() > site_.large->size();
  }));
  EXPECT_GT(std::chrono::steady_clock::now() - begun, std::chrono::milliseconds(500));
  EXPECT_EQ(server_->refusals().slow, 0);
}

TEST_F(WebServer, CutsAndCountsAnAnswerThatNobodyTakes) {
  WebPeer& stalled = peer();
  stalled.get("/large");
  most_received_ = 0;
  ASSERT_TRUE(until([&] { return server_->refusals().slow == 1; }));
  most_received_ = SIZE_MAX;
  EXPECT_TRUE(ends(stalled));
  EXPECT_GT(stalled.received().size(), 0U);
  EXPECT_LT(stalled.received().size(), site_.large->size());
}

TEST_F(WebServer, IsHeldUpByNobodyWhoDoesNotRead) {
  site_.flood = std::make_shared<const std::string>(1 << 20, 'x');
  WebPeer& stalled = talker();
  ASSERT_TRUE(until([&] { return stalled.received().size() > site_.flood->size(); }));
  std::list<WebPeer> others;
  std::swap(others, peers_);  // nobody reads for it
  WebPeer& quick = peer();
  quick.get("/");
  EXPECT_TRUE(answers(quick, "hello"));
  EXPECT_EQ(server_->conversations(), 1);
}

TEST_F(WebServer, EndsAConversationWhoseWordIsNotTaken) {
  site_.flood = std::make_shared<const std::string>(4 << 20, 'x');
  WebPeer& stalled = talker();
  ASSERT_TRUE(until([&] { return stalled.received().size() > 1000; }));
  most_received_ = 0;
  stalled.say("nonsense");
  EXPECT_TRUE(until([&] { return server_->conversations() == 0; }));
  EXPECT_EQ(server_->refusals().malformed, 1);
}

TEST_F(WebServer, SaysWhyItEndsAConversationBehindTheWordThatIsUnderWay) {
  site_.flood = std::make_shared<const std::string>(4 << 20, 'x');
  WebPeer& one = talker();
  ASSERT_TRUE(until([&] { return one.received().size() > 1000; }));
  one.say("nonsense");
  EXPECT_TRUE(answers(one, "allowed: sense"));
  EXPECT_TRUE(ends(one));
}

TEST_F(WebServer, EndsAConversationInWhichNothingComes) {
  parameters_.longest_silence = 0.2;
  begin();
  WebPeer& vanished = talker();  // and answers no ping
  EXPECT_TRUE(ends(vanished));
  EXPECT_TRUE(until([&] { return server_->conversations() == 0; }));
  EXPECT_EQ(server_->refusals().slow, 1);
}

TEST_F(WebServer, GivesThePlaceOfTheLongestIdleAway) {
  parameters_.patience = 10.0;
  begin();
  WebPeer& page = talker();
  ASSERT_TRUE(answers(page, "hello"));
  WebPeer& longest = peer();
  longest.get("/");
  ASSERT_TRUE(answers(longest, "hello"));
  for (int i = server_->connections(); i < parameters_.most_clients; ++i) {
    WebPeer& one = peer();
    one.get("/");
    ASSERT_TRUE(answers(one, "hello"));
  }
  WebPeer& late = peer();
  late.get("/");
  EXPECT_TRUE(answers(late, "hello"));
  EXPECT_TRUE(ends(longest));
  EXPECT_EQ(server_->refusals().connections, 1);
  EXPECT_EQ(server_->connections(), parameters_.most_clients);
  for (WebPeer& one : peers_) EXPECT_EQ(one.ended(), &one == &longest);
}

TEST_F(WebServer, TurnsAwayWhoeverComesWhileAllConverse) {
  for (int i = 0; i < parameters_.most_clients; ++i) ASSERT_TRUE(answers(talker(), "hello"));
  WebPeer& late = peer();
  late.get("/");
  EXPECT_TRUE(ends(late));
  EXPECT_EQ(late.received(), "");
  EXPECT_EQ(server_->refusals().connections, 1);
  EXPECT_EQ(server_->conversations(), parameters_.most_clients);
}

TEST_F(WebServer, GivesThePlaceOfAConversationAwayInWhichNothingCameForLong) {
  parameters_.safe_silence = 0.1;
  begin();
  WebPeer& vanished = talker();
  for (int i = 1; i < parameters_.most_clients; ++i) ASSERT_TRUE(answers(talker(), "hello"));
  std::this_thread::sleep_for(std::chrono::milliseconds(100));
  for (WebPeer& one : peers_) {
    if (&one != &vanished) one.say("still here");
  }
  for (WebPeer& one : peers_) {
    if (&one == &vanished) continue;
    ASSERT_TRUE(answers(one, "still here"));
  }
  WebPeer& late = peer();
  late.get("/");
  EXPECT_TRUE(answers(late, "hello"));
  EXPECT_TRUE(ends(vanished));
  EXPECT_EQ(server_->conversations(), parameters_.most_clients - 1);
}

}  // namespace
}  // namespace markservo::mmi
