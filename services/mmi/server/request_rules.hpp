#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "services/mmi/server/web_site.hpp"

namespace markservo::mmi {

// Who may ask. A page of any site that is open in the same browser can reach a loopback address: it names itself by
// Origin, and a name that it has made to mean 127.0.0.1 stands in Host.
struct RequestRules {
  std::vector<std::string> hosts;  // allowed besides loopback names, without port, in lower case
  std::string token;               // empty: none is asked

  // Why `request` is refused; empty when it may be answered. Asks for no token. `is_page`: for a file of the page,
  // which tells nothing and does nothing: it may be opened by another site's link, in a window of its own.
  std::string refusal(const RequestHead& request, bool is_page = false) const;
  // Whether `given` is the token, or none is asked; in a time that does not tell how much of it is right.
  bool admits(std::string_view given) const;
};

// "localhost", "127.0.0.1", "[::1]" and what is below .localhost, with or without a port.
bool is_loopback_name(std::string_view host);

// `host` without its port, in lower case.
std::string host_without_port(std::string_view host);

}  // namespace markservo::mmi
