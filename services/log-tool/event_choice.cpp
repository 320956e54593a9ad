#include "services/log-tool/event_choice.hpp"

#include <algorithm>
#include <map>
#include <set>

#include "common/channel_pattern/channel_pattern.hpp"

namespace markservo::log_tool {
namespace {

class ChannelFilter {
 public:
  ChannelFilter(const EventChoice& choice, const std::set<std::string>& names) : all_(choice.channels.empty()) {
    for (const std::string& text : choice.channels) wanted_.emplace_back(text, names);
    for (const std::string& text : choice.without) unwanted_.emplace_back(text, names);
  }

  bool takes(std::string_view channel) {
    const auto known = known_.find(channel);
    if (known != known_.end()) return known->second;
    const std::string name(channel);
    const auto matches = [&name](const ChannelPattern& expression) { return expression.matches(name); };
    const bool taken = (all_ || std::any_of(wanted_.begin(), wanted_.end(), matches)) &&
                       std::none_of(unwanted_.begin(), unwanted_.end(), matches);
    known_.emplace(name, taken);
    return taken;
  }

 private:
  bool all_;
  std::vector<ChannelPattern> wanted_;
  std::vector<ChannelPattern> unwanted_;
  std::map<std::string, bool, std::less<>> known_;
};

}  // namespace

std::set<std::string> channels_of(const std::vector<logs::LogEvent>& events) {
  std::set<std::string, std::less<>> names;
  for (const logs::LogEvent& event : events) {
    if (names.find(event.channel) == names.end()) names.emplace(event.channel);
  }
  return {names.begin(), names.end()};
}

std::vector<logs::LogEvent> chosen(const std::vector<logs::LogEvent>& events, const EventChoice& choice) {
  ChannelFilter filter(choice, channels_of(events));
  std::vector<logs::LogEvent> taken;
  for (const logs::LogEvent& event : events) {
    const double after = logs::seconds_apart(events.front().utime, event.utime);
    if ((choice.from && after < *choice.from) || (choice.to && after >= *choice.to)) continue;
    if (filter.takes(event.channel)) taken.push_back(event);
  }
  return taken;
}

}  // namespace markservo::log_tool
