#include "common/bus/health.hpp"

#include <fmt/core.h>

namespace markservo::bus {
namespace {

bool says_why(const Health& own) {
  return (own.state == kWaiting || own.state == kStale) && !own.reason.empty();
}

}  // namespace

std::optional<Health> health_of(const std::vector<NeededInput>& inputs) {
  for (const NeededInput& input : inputs) {
    if (input.accepted_age && *input.accepted_age <= input.max_age) continue;
    const char* state = input.accepted_age ? kStale : kWaiting;
    if (input.refused_age && *input.refused_age <= input.max_age) {
      return Health{state, input.channel + ": all refused: " + input.refusal};
    }
    if (!input.accepted_age) return Health{state, input.channel + ": not heard yet"};
    return Health{state, input.channel + fmt::format(": not heard for more than {:.3g} s", input.max_age)};
  }
  return std::nullopt;
}

Health told_health(const Health& own, const std::optional<Health>& of_network, const std::optional<Health>& of_inputs) {
  if (of_network) return *of_network;
  if (of_inputs && !says_why(own)) return *of_inputs;
  return own;
}

}  // namespace markservo::bus
