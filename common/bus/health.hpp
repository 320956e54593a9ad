#pragma once

// What SERVICE_STATUS says of a service: its own word, unless the bus knows better. No bus and no clock in here.

#include <optional>
#include <string>
#include <vector>

namespace markservo::bus {

// How a service is: SERVICE_STATUS's state and reason.
struct Health {
  std::string state;
  std::string reason;  // for people
};

inline bool operator==(const Health& a, const Health& b) {
  return a.state == b.state && a.reason == b.reason;
}

// The states in which a service cannot do its work; every other one counts as ready.
inline constexpr const char* kStarting = "starting";  // it has said nothing of itself yet
inline constexpr const char* kWaiting = "waiting";    // for what it never had, or for its network
inline constexpr const char* kStale = "stale";        // what it works on has stopped coming

// A channel that a service cannot do without.
struct NeededInput {
  std::string channel;
  double max_age = 0.0;                // s
  std::optional<double> accepted_age;  // s, since a message was last accepted; nothing if none ever was
  std::optional<double> refused_age;   // s, since one was last refused
  std::string refusal;                 // why that was refused
};

// Of a service that needs `inputs`, by the first that is missing; nothing if none is. What was refused a moment ago and
// not accepted counts as missing, and the reason says why it was refused.
std::optional<Health> health_of(const std::vector<NeededInput>& inputs);

// What is to be told: what the bus knows before what the service says of itself, unless that says that it cannot work
// and why. The service's own is told again as soon as the bus has nothing to say.
Health told_health(const Health& own, const std::optional<Health>& of_network, const std::optional<Health>& of_inputs);

}  // namespace markservo::bus
