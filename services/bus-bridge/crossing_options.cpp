#include "services/bus-bridge/crossing_options.hpp"

#include <algorithm>
#include <markservo/channels.hpp>
#include <set>

#include "common/bus/bus_url.hpp"
#include "common/robot/configuration_error.hpp"

namespace markservo::bus_bridge {
namespace {

// The port in a udpm:// URL, as it stands there; LCM's own default where none does.
std::string port_of(const std::string& url) {
  const std::string address = url.substr(0, url.find('?'));
  const std::size_t colon = address.rfind(':');
  const bool none = colon == std::string::npos || colon < std::string("udpm://").size();
  return none ? "7667" : address.substr(colon + 1);
}

bool is_channel(const std::string& name) {
  const auto allowed = [](char c) { return (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_'; };
  return !name.empty() && std::all_of(name.begin(), name.end(), allowed);
}

void check_channels(const char* option, const std::vector<std::string>& channels) {
  std::set<std::string> seen;
  for (const std::string& channel : channels) {
    if (!is_channel(channel)) {
      throw ConfigurationError(std::string(option) + " names '" + channel +
                               "'; allowed: channels of upper-case letters, digits and _, each by its name");
    }
    if (!seen.insert(channel).second) {
      throw ConfigurationError(std::string(option) + " names " + channel + " twice; allowed: once");
    }
  }
}

// What the table of channels says against it. A channel that it does not have may cross.
void check_by_the_table(const Crossing& crossing, const std::string& channel) {
  const channels::Entry* entry = channels::find(channel);
  if (entry == nullptr) return;
  if (entry->large && crossing.largest <= Crossing().largest) {
    throw ConfigurationError("--send or --receive names " + channel + ", whose messages may exceed " +
                             std::to_string(crossing.largest) + " bytes (--largest); allowed: small channels");
  }
  const auto names = [&channel](const std::vector<std::string>& list) {
    return std::find(list.begin(), list.end(), channel) != list.end();
  };
  if (entry->second != channels::Second::kAllowed && names(crossing.send) && names(crossing.receive)) {
    throw ConfigurationError("--send and --receive both name " + channel +
                             ", which one alone may write; allowed: one of them");
  }
}

}  // namespace

void check(const Crossing& crossing) {
  if (!bus::is_udpm(crossing.link_url)) {
    throw ConfigurationError("--link-url is '" + crossing.link_url +
                             "'; allowed: udpm://GROUP:PORT?ttl=1, the same on both hosts");
  }
  if (crossing.send.empty() && crossing.receive.empty()) {
    throw ConfigurationError("--send and --receive name no channel; allowed: at least one of them names one");
  }
  check_channels("--send", crossing.send);
  check_channels("--receive", crossing.receive);
  for (const auto* list : {&crossing.send, &crossing.receive}) {
    for (const std::string& channel : *list) check_by_the_table(crossing, channel);
  }
}

void check_beside(const Crossing& crossing, const std::string& local_url) {
  if (!bus::is_udpm(local_url)) {
    throw ConfigurationError("--lcm-url is '" + local_url + "'; allowed: a live bus, udpm://");
  }
  if (port_of(crossing.link_url) == port_of(local_url)) {
    throw ConfigurationError("--link-url is " + crossing.link_url + ", on the port of this host's bus " + local_url +
                             "; allowed: another port, for LCM tells buses apart by it");
  }
}

}  // namespace markservo::bus_bridge
