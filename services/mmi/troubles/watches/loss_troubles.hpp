#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>

#include "services/mmi/troubles/finding.hpp"
#include "services/mmi/troubles/known.hpp"
#include "services/mmi/troubles/remedies.hpp"
#include "services/mmi/troubles/words.hpp"

namespace markservo::mmi {

struct LossTroubleParameters {
  double share = 0.1;         // of a channel's messages, from one word of a service to the next: fewer harm no control
  std::int64_t least = 5;     // messages: fewer are a busy machine's
  double word = 2.5;          // s for which a service's word counts, of one a second
  double interval_max = 3.5;  // s between two words: a service that was silent for longer has hung, and lost by that
};

// messages_lost: a service has lost messages since its word before, by its own count. What it lost when a writer that
// it refused, or heard nothing of, is heard again does not count.
class LossTroubles {
 public:
  explicit LossTroubles(LossTroubleParameters parameters = {}) : parameters_(parameters) {}

  void observe(const ServiceWord& word, double now);

  // Whether anybody loses messages.
  bool any(double now) const { return worst(now).has_value(); }
  void find(const Remedies& remedies, double now, Findings& found) const;

 private:
  struct Input {
    ReceivedWord counts;     // at the last word
    bool was_heard = false;  // between the last two
    double share = 0.0;      // lost, between the last two; 0: too little to tell
    Since since;             // it loses
  };
  struct Service {
    std::int64_t session = 0;
    std::map<std::string, Input> inputs;  // by channel, those of the table
    double heard = 0.0;
  };
  struct Loss {
    std::string service;
    std::string channel;
    const Input* input = nullptr;
  };

  void compare(const ReceivedWord& counts, Since now, bool follows, Input& input) const;
  std::optional<Loss> worst(double now) const;

  LossTroubleParameters parameters_;
  std::map<std::pair<std::string, std::string>, Service> services_;  // by host and name
};

}  // namespace markservo::mmi
