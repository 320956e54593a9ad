#include "services/mmi/server/request_rules.hpp"

#include <algorithm>
#include <cctype>

#include "services/mmi/server/secret.hpp"

namespace markservo::mmi {
namespace {

bool is_ipv4_loopback(std::string_view name) {
  if (name.substr(0, 4) != "127.") return false;
  return std::count(name.begin(), name.end(), '.') == 3 &&
         std::all_of(name.begin(), name.end(), [](unsigned char c) { return c == '.' || std::isdigit(c) != 0; });
}

bool ends_with(std::string_view text, std::string_view end) {
  return text.size() >= end.size() && text.substr(text.size() - end.size()) == end;
}

}  // namespace

std::string host_without_port(std::string_view host) {
  const std::size_t bracket = host.find(']');
  const std::size_t colon = host.find(':', bracket == std::string_view::npos ? 0 : bracket);
  std::string name(host.substr(0, colon));
  std::transform(name.begin(), name.end(), name.begin(), [](unsigned char c) { return std::tolower(c); });
  return name;
}

bool is_loopback_name(std::string_view host) {
  const std::string name = host_without_port(host);
  return name == "localhost" || name == "[::1]" || is_ipv4_loopback(name) || ends_with(name, ".localhost");
}

std::string RequestRules::refusal(const RequestHead& request, bool is_page) const {
  if (request.method != "GET" && request.method != "HEAD") {
    return "method " + request.method + "; allowed: GET, HEAD";
  }
  const std::string name = host_without_port(request.host);
  if (!is_loopback_name(request.host) && std::find(hosts.begin(), hosts.end(), name) == hosts.end()) {
    return "Host is '" + request.host + "'; allowed: a loopback name, or one given by --host";
  }
  if (request.origin && *request.origin != "http://" + request.host) {
    return "Origin is '" + *request.origin + "'; allowed: the page's own, http://" + request.host;
  }
  // Pictures and scripts are fetched by a foreign page without an Origin, but browsers say whose they are.
  const bool is_followed_link =
      is_page && !request.upgrade && request.fetch_mode == "navigate" && request.fetch_destination == "document";
  const bool is_own = request.fetch_site.empty() || request.fetch_site == "same-origin" || request.fetch_site == "none";
  if (!is_own && !is_followed_link) {
    return "asked by a page of another site (Sec-Fetch-Site: " + request.fetch_site + "); allowed: the page's own";
  }
  if (request.upgrade && !request.origin && !request.by_path) {
    return "a WebSocket without Origin; allowed: one that names it, or by a socket with a path";
  }
  return {};
}

bool RequestRules::admits(std::string_view given) const {
  return token.empty() || is_secret(given, token);
}

}  // namespace markservo::mmi
