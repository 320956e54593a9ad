#include "services/mmi/troubles/session_names.hpp"

#include <fmt/core.h>

#include "services/mmi/troubles/known.hpp"

namespace markservo::mmi {

void SessionNames::observe(const ServiceWord& word, double now) {
  if (Service* service = known_or_new(services_, word.session, now)) *service = {word.name, word.host, word.pid, now};
}

std::string SessionNames::service(std::int64_t session) const {
  const auto found = services_.find(session);
  return found == services_.end() ? "" : found->second.name;
}

std::string SessionNames::words(std::int64_t session) const {
  const auto found = services_.find(session);
  if (found == services_.end()) return fmt::format("session {}", session);
  const Service& service = found->second;
  return fmt::format("{} (process {} on {})", service.name, service.pid, service.host);
}

}  // namespace markservo::mmi
