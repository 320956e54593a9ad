#include "services/mmi/site_node.hpp"

#include "common/bus/session.hpp"
#include "common/reflection/message_json.hpp"
#include "common/time/clocks.hpp"
#include "common/watch/watch_json.hpp"
#include "services/mmi/troubles/state_json.hpp"

namespace markservo::mmi {
namespace {

Answer plain(int status, const std::string& line) {
  return {status, "text/plain; charset=utf-8", std::make_shared<const std::string>(line + "\n")};
}

Answer json_answer(const nlohmann::ordered_json& json) {
  return {200, "application/json", std::make_shared<const std::string>(reflection::json_text(json))};
}

std::string path_of(const RequestHead& request) {
  return request.target.substr(0, request.target.find('?'));
}

}  // namespace

SiteNode::SiteNode(Source& source, std::string hello, PageFiles page, RequestRules rules)
    : source_(source), hello_(std::move(hello)), page_(std::move(page)), rules_(std::move(rules)) {}

bool SiteNode::admits(const std::string& token) const {
  const Desk* desk = source_.desk();
  return rules_.admits(token) || (desk != nullptr && desk->admits(token));
}

std::int64_t SiteNode::new_session() {
  return bus::random_session();
}

double SiteNode::now() const {
  return steady_seconds();
}

std::unique_ptr<Conversation> SiteNode::converse() {
  FeedHost& host = *this;  // a private base: only here is the conversion allowed
  return std::make_unique<ClientFeed>(host, source_.shown());
}

Answer SiteNode::answer(const RequestHead& request) {
  const std::string path = path_of(request);
  const Answer* file = page_.find(path);
  const std::string refused = rules_.refusal(request, file != nullptr);
  if (!refused.empty()) return plain(403, refused);
  if (file != nullptr) return *file;
  const bool is_known =
      path == "/state.json" || path == "/channels.json" || path == "/frame/left.jpg" || path == "/frame/right.jpg";
  if (!is_known) return plain(404, "nothing here; allowed: /, /state.json, /channels.json, /frame/left.jpg, /socket");
  if (!admits(request.bearer)) return plain(401, "no token; allowed: with Authorization: Bearer TOKEN");
  if (path == "/state.json") return state();
  if (path == "/channels.json") return channels();
  return picture(path == "/frame/left.jpg");
}

std::string SiteNode::refusal(const RequestHead& request) const {
  const std::string path = path_of(request);
  if (path != "/socket") return "a WebSocket at '" + path + "'; allowed: /socket";
  return rules_.refusal(request);
}

Answer SiteNode::state() const {
  const WorldReader& world = source_.world();
  nlohmann::ordered_json state = state_json(world.state(), world.troubles());
  if (refusals_ != nullptr) {
    state["refused"] = {{"requests", refusals_->requests},
                        {"malformed", refusals_->malformed},
                        {"slow", refusals_->slow},
                        {"connections", refusals_->connections},
                        {"behind", refusals_->behind}};
  }
  if (const Desk* desk = source_.desk()) state["refused_commands"] = desk->refused();
  return json_answer(state);
}

Answer SiteNode::channels() const {
  const WorldReader& world = source_.world();
  return json_answer(watch::watch_json(world.watch(), world.heard_for(), world.now()));
}

Answer SiteNode::picture(bool left) {
  const std::shared_ptr<const Frame> frame = source_.world().frames().newest();
  const std::shared_ptr<const JpegPair> pair = frame ? pictures_.jpegs(frame) : nullptr;
  if (!pair) return plain(404, "no picture yet");
  return {200, "image/jpeg", std::make_shared<const std::string>(left ? pair->left : pair->right)};
}

}  // namespace markservo::mmi
