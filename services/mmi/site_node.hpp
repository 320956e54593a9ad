#pragma once

#include <memory>
#include <string>

#include "services/mmi/feed/client_feed.hpp"
#include "services/mmi/page_files.hpp"
#include "services/mmi/server/request_rules.hpp"
#include "services/mmi/source.hpp"

namespace markservo::mmi {

// What the web server has to tell of one source.
class SiteNode final : public WebSite, private FeedHost {
 public:
  // `hello`: a ClientFeed's, but for its events, without the last brace. `source` must outlive this.
  SiteNode(Source& source, std::string hello, PageFiles page, RequestRules rules);

  // What the server has refused, for /state.json.
  void count(const Refusals& refusals) { refusals_ = &refusals; }

  Answer answer(const RequestHead& request) override;
  std::string refusal(const RequestHead& request) const override;
  std::unique_ptr<Conversation> converse() override;

 private:
  Answer state() const;
  Answer channels() const;
  Answer picture(bool left);

  const std::string& hello() const override { return hello_; }
  // Who may command may look.
  bool admits(const std::string& token) const override;
  std::string stop(const std::string& reason) override { return source_.stop(reason); }
  const VersionedText& stop_state() const override { return source_.stop_state(); }
  PictureMaker& pictures() override { return pictures_; }
  Desk* desk() override { return source_.desk(); }
  std::int64_t new_session() override;
  double now() const override;

  Source& source_;
  std::string hello_;
  PageFiles page_;
  RequestRules rules_;
  PictureMaker pictures_;
  const Refusals* refusals_ = nullptr;
};

}  // namespace markservo::mmi
