#include "services/mmi/server/request_rules.hpp"

#include <gtest/gtest.h>

namespace markservo::mmi {
namespace {

RequestHead request(const std::string& host, std::optional<std::string> origin = std::nullopt) {
  RequestHead head;
  head.method = "GET";
  head.target = "/";
  head.host = host;
  head.origin = std::move(origin);
  return head;
}

std::string refusal(const RequestHead& head) {
  return RequestRules{{"robot.lab"}, ""}.refusal(head);
}

TEST(RequestRules, AnswerToLoopbackNamesWithAnyPort) {
  for (const char* host : {"127.0.0.1:8080", "localhost", "LOCALHOST:9", "[::1]:8080", "127.1.2.3", "a.localhost:1"}) {
    EXPECT_EQ(refusal(request(host)), "") << host;
  }
}

TEST(RequestRules, AnswerToNamesThatAreGiven) {
  EXPECT_EQ(refusal(request("robot.lab:8080")), "");
  EXPECT_EQ(refusal(request("Robot.Lab")), "");
}

TEST(RequestRules, RefuseAnyOtherHost) {
  for (const char* host : {"evil.example", "", "127.0.0.1.evil.example", "localhost.evil.example", "127.evil.1.1",
                           "robot.lab.evil.example", "[::2]:8080", "127.0.0.1@evil.example"}) {
    EXPECT_NE(refusal(request(host)).find("Host"), std::string::npos) << host;
  }
}

TEST(RequestRules, RefuseAnOriginThatIsNotTheHost) {
  EXPECT_EQ(refusal(request("127.0.0.1:8080", "http://127.0.0.1:8080")), "");
  for (const char* origin : {"http://evil.example", "https://127.0.0.1:8080", "http://127.0.0.1:8081",
                             "http://localhost:8080", "null", "", "http://127.0.0.1:8080.evil.example"}) {
    EXPECT_NE(refusal(request("127.0.0.1:8080", origin)).find("Origin"), std::string::npos) << origin;
  }
}

TEST(RequestRules, RefuseWhatAForeignPageFetchesWithoutAnOrigin) {
  RequestHead head = request("127.0.0.1:8080");
  for (const char* own : {"same-origin", "none"}) {
    head.fetch_site = own;
    EXPECT_EQ(refusal(head), "") << own;
  }
  for (const char* foreign : {"cross-site", "same-site"}) {
    head.fetch_site = foreign;
    EXPECT_NE(refusal(head), "") << foreign;
  }
}

TEST(RequestRules, LetALinkOfAnotherSiteOpenThePageAndNothingElse) {
  RequestHead head = request("127.0.0.1:8080");
  head.fetch_site = "cross-site";
  head.fetch_mode = "navigate";
  head.fetch_destination = "document";
  const RequestRules rules;
  EXPECT_EQ(rules.refusal(head, true), "");
  EXPECT_NE(rules.refusal(head, false), "");
  head.upgrade = true;
  head.origin = "http://127.0.0.1:8080";
  EXPECT_NE(rules.refusal(head, true), "");
  head.upgrade = false;
  head.fetch_destination = "iframe";
  EXPECT_NE(rules.refusal(head, true), "");
  head.fetch_destination = "document";
  head.fetch_mode = "no-cors";
  EXPECT_NE(rules.refusal(head, true), "");
  head.fetch_mode = "navigate";
  head.host = "evil.example";
  EXPECT_NE(rules.refusal(head, true), "");
}

TEST(RequestRules, RefuseAWebSocketWithoutOriginUnlessItComesByAPath) {
  RequestHead head = request("127.0.0.1:8080");
  head.upgrade = true;
  EXPECT_NE(refusal(head).find("without Origin"), std::string::npos);
  head.by_path = true;
  EXPECT_EQ(refusal(head), "");
}

TEST(RequestRules, RefuseWhatWouldChangeSomething) {
  RequestHead head = request("localhost");
  for (const char* method : {"POST", "PUT", "DELETE", "OPTIONS", "TRACE", ""}) {
    head.method = method;
    EXPECT_NE(refusal(head).find("method"), std::string::npos) << method;
  }
}

TEST(RequestRules, AskForTheTokenWhereThereIsOne) {
  EXPECT_TRUE((RequestRules{{}, ""}.admits("anything")));
  const RequestRules rules{{}, "a secret of the lab"};
  EXPECT_TRUE(rules.admits("a secret of the lab"));
  for (const char* wrong : {"", "a secret of the la", "a secret of the lab2", "b secret of the lab"}) {
    EXPECT_FALSE(rules.admits(wrong)) << wrong;
  }
}

}  // namespace
}  // namespace markservo::mmi
