#pragma once

// The bus that the environment names where nobody names one on the command line.

#include <optional>
#include <string>

#include "common/bus/options.hpp"

namespace markservo::bus {

struct NamedBus {
  std::string variable;  // that names it
  std::string url;
};

// By MARKSERVO_LCM_URL, else by LCM_DEFAULT_URL, which all of LCM's own programs obey; an empty variable names none.
std::optional<NamedBus> named_bus();

// Adds --lcm-url, in whose place the environment's bus counts. `url` is the default, `what` is for --help.
Option add_lcm_url(const Options& add, std::string& url, const std::string& what);

// " (the bus that LCM_DEFAULT_URL names)" where `text` speaks of a bus that LCM's variable names: who set it for other
// programs may not think of ours. Empty otherwise.
std::string told_by(const std::string& text);

}  // namespace markservo::bus
