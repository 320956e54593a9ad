#pragma once

// What SERVICE_STATUS says of a service: its own word, unless the bus knows better. No bus and no clock in here.

#include <optional>
#include <string>
#include <vector>

namespace markservo::bus {

struct Word {
  std::string state;
  std::string reason;
};

inline bool operator==(const Word& a, const Word& b) {
  return a.state == b.state && a.reason == b.reason;
}

// The states in which a service cannot do its work; every other word counts as ready.
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

// The first need that is not met, as a word; nothing if all are. What was refused a moment ago and not accepted counts
// as not there, and the reason says why it was refused.
std::optional<Word> word_about(const std::vector<NeededInput>& inputs);

// What is to be told: the bus's word before the service's own, but for one that says itself that it cannot work and
// why. The own word is told again as soon as the bus has none.
Word told_word(const Word& own, const std::optional<Word>& of_network, const std::optional<Word>& of_inputs);

}  // namespace markservo::bus
