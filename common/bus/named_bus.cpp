#include "common/bus/named_bus.hpp"

#include <cstdlib>
#include <cstring>

namespace markservo::bus {
namespace {

constexpr const char* kOurs = "MARKSERVO_LCM_URL";
constexpr const char* kOfLcm = "LCM_DEFAULT_URL";

// Whether the whole URL stands in the text, which may go on behind it: udpm:// is not what udpm://10.0.0.1 begins with.
bool speaks_of(const std::string& text, const std::string& url) {
  for (std::size_t at = text.find(url); at != std::string::npos; at = text.find(url, at + 1)) {
    const std::string behind = text.substr(at + url.size(), 2);
    if (behind.empty() || behind == ":" || behind == ": " || std::strchr(" ',;)", behind[0]) != nullptr) return true;
  }
  return false;
}

}  // namespace

std::optional<NamedBus> named_bus() {
  for (const char* variable : {kOurs, kOfLcm}) {
    const char* url = std::getenv(variable);
    if (url != nullptr && *url != '\0') return NamedBus{variable, url};
  }
  return std::nullopt;
}

Option add_lcm_url(const Options& add, std::string& url, const std::string& what) {
  const std::optional<NamedBus> named = named_bus();
  return add.option("--lcm-url", url, what + " (without MARKSERVO_LCM_URL that of LCM_DEFAULT_URL)")
      .environment(named ? named->variable : kOurs)
      .show_default();
}

std::string told_by(const std::string& text) {
  const std::optional<NamedBus> named = named_bus();
  const bool by_lcm = named && named->variable == kOfLcm && speaks_of(text, named->url);
  return by_lcm ? std::string(" (the bus that ") + kOfLcm + " names)" : std::string();
}

}  // namespace markservo::bus
