#include "services/log-tool/event_choice.hpp"

#include <regex.h>

#include <algorithm>
#include <array>
#include <map>
#include <memory>
#include <stdexcept>

namespace markservo::log_tool {
namespace {

// An expression for a whole name.
class NameExpression {
 public:
  explicit NameExpression(const std::string& text) {
    auto compiled = std::make_unique<regex_t>();
    const int error = regcomp(compiled.get(), ("^(" + text + ")$").c_str(), REG_EXTENDED | REG_NOSUB);
    if (error != 0) {
      std::array<char, 200> why{};
      regerror(error, compiled.get(), why.data(), why.size());
      throw std::invalid_argument("channel expression '" + text + "': " + why.data() +
                                  "; allowed: an extended regular expression (POSIX)");
    }
    compiled_ = {compiled.release(), [](regex_t* regex) {
                   regfree(regex);
                   delete regex;
                 }};
  }
  bool matches(const std::string& name) const { return regexec(compiled_.get(), name.c_str(), 0, nullptr, 0) == 0; }

 private:
  std::shared_ptr<regex_t> compiled_;
};

class ChannelFilter {
 public:
  explicit ChannelFilter(const EventChoice& choice) : all_(choice.channels.empty()) {
    for (const std::string& text : choice.channels) wanted_.emplace_back(text);
    for (const std::string& text : choice.without) unwanted_.emplace_back(text);
  }

  bool takes(std::string_view channel) {
    const auto known = known_.find(channel);
    if (known != known_.end()) return known->second;
    const std::string name(channel);
    const auto matches = [&name](const NameExpression& expression) { return expression.matches(name); };
    const bool taken = (all_ || std::any_of(wanted_.begin(), wanted_.end(), matches)) &&
                       std::none_of(unwanted_.begin(), unwanted_.end(), matches);
    known_.emplace(name, taken);
    return taken;
  }

 private:
  bool all_;
  std::vector<NameExpression> wanted_;
  std::vector<NameExpression> unwanted_;
  std::map<std::string, bool, std::less<>> known_;
};

}  // namespace

std::vector<Event> chosen(const std::vector<Event>& events, const EventChoice& choice) {
  ChannelFilter filter(choice);
  std::vector<Event> taken;
  for (const Event& event : events) {
    const double after = seconds_apart(events.front().utime, event.utime);
    if ((choice.from && after < *choice.from) || (choice.to && after >= *choice.to)) continue;
    if (filter.takes(event.channel)) taken.push_back(event);
  }
  return taken;
}

}  // namespace markservo::log_tool
