#include "services/mmi/site_node.hpp"

#include <gtest/gtest.h>

#include "tests/unit/mmi/made_up_source.hpp"
#include "tests/unit/temporary_folder.hpp"

namespace markservo::mmi {
namespace {

class Site : public ::testing::Test {
 protected:
  Site() { site_.count(refusals_); }

  static RequestHead request(const std::string& target) {
    RequestHead head;
    head.method = "GET";
    head.target = target;
    head.host = "localhost";
    head.bearer = "a secret of the lab";
    return head;
  }
  // Of the page of another site.
  static RequestHead foreign(const std::string& target, const std::string& mode, const std::string& destination) {
    RequestHead head = request(target);
    head.fetch_site = "cross-site";
    head.fetch_mode = mode;
    head.fetch_destination = destination;
    return head;
  }

  PageFiles page() {
    folder_.write("index.html", "<!doctype html>");
    return PageFiles(folder_.file(""));
  }

  test::TemporaryFolder folder_;
  MadeUpSource source_;
  Refusals refusals_;
  SiteNode site_{source_, "{}", page(), {{}, "a secret of the lab"}};
};

TEST_F(Site, ShowsWhoHasTheTokenWhatIsHeard) {
  for (const char* target : {"/state.json", "/state.json?x=1", "/channels.json"}) {
    const Answer answer = site_.answer(request(target));
    EXPECT_EQ(answer.status, 200) << target;
    EXPECT_EQ(answer.content_type, "application/json") << target;
  }
}

TEST_F(Site, ShowsNobodyElseAnythingButThePage) {
  for (const char* target : {"/state.json", "/channels.json", "/frame/left.jpg", "/frame/right.jpg"}) {
    RequestHead head = request(target);
    for (const char* token : {"", "a guess of the lab!"}) {
      head.bearer = token;
      EXPECT_EQ(site_.answer(head).status, 401) << target;
    }
  }
  RequestHead head = request("/");
  head.bearer = "";
  EXPECT_EQ(site_.answer(head).status, 200);
}

TEST_F(Site, HasNothingElsewhere) {
  for (const char* target : {"/none", "", "/state.json/", "/../state.json", "/index.html/x", "/socket"}) {
    EXPECT_EQ(site_.answer(request(target)).status, 404) << target;
  }
  EXPECT_EQ(site_.answer(request("/frame/left.jpg")).status, 404);  // no picture yet
}

TEST_F(Site, RefusesAnotherHostWhateverItAsks) {
  for (const char* target : {"/", "/state.json", "/none"}) {
    RequestHead head = request(target);
    head.host = "evil.example";
    EXPECT_EQ(site_.answer(head).status, 403) << target;
  }
}

TEST_F(Site, TellsWhatWasRefused) {
  refusals_.slow = 1234;
  EXPECT_NE(site_.answer(request("/state.json")).body->find("1234"), std::string::npos);
}

TEST_F(Site, IsReachedByALinkOfAnotherSiteButNotReadByIt) {
  EXPECT_EQ(site_.answer(foreign("/", "navigate", "document")).status, 200);
  EXPECT_EQ(site_.answer(foreign("/index.html?x", "navigate", "document")).status, 200);
  EXPECT_EQ(site_.answer(foreign("/", "navigate", "iframe")).status, 403);
  EXPECT_EQ(site_.answer(foreign("/", "no-cors", "document")).status, 403);
  EXPECT_EQ(site_.answer(foreign("/state.json", "navigate", "document")).status, 403);
  EXPECT_EQ(site_.answer(foreign("/frame/left.jpg", "navigate", "document")).status, 403);
}

TEST_F(Site, OpensAWebSocketAtOnePlaceOnly) {
  RequestHead head = request("/socket");
  head.upgrade = true;
  head.origin = "http://localhost";
  EXPECT_EQ(site_.refusal(head), "");
  head.target = "/socket?x=1";
  EXPECT_EQ(site_.refusal(head), "");
  for (const char* target : {"/", "/state.json", "/socket/", "", "//socket"}) {
    head.target = target;
    EXPECT_NE(site_.refusal(head).find("allowed: /socket"), std::string::npos) << target;
  }
}

TEST_F(Site, OpensNoWebSocketForAnotherSite) {
  RequestHead head = foreign("/socket", "navigate", "document");
  head.upgrade = true;
  head.origin = "http://localhost";
  EXPECT_NE(site_.refusal(head), "");
}

}  // namespace
}  // namespace markservo::mmi
