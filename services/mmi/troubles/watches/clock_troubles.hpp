#pragma once

#include <cstdint>
#include <map>
#include <string>

#include "services/mmi/troubles/finding.hpp"
#include "services/mmi/troubles/known.hpp"
#include "services/mmi/troubles/remedies.hpp"
#include "services/mmi/troubles/session_names.hpp"
#include "services/mmi/troubles/words.hpp"

namespace markservo::mmi {

struct ClockTroubleParameters {
  double window =
      1.2;            // s: a sender without a message from the future for so long is mended; all but one speak oftener
  int messages = 2;   // so many of them in a row: one alone may be a slip
  double word = 2.5;  // s for which a service's word counts, of one a second
};

// clock_ahead: messages have a utime further ahead of the clock that heard them than hosts may disagree, so that every
// service refuses them; or a service says that it refuses some for that, where the clock here is as wrong.
class ClockTroubles {
 public:
  explicit ClockTroubles(ClockTroubleParameters parameters = {}) : parameters_(parameters) {}

  void observe(const AnyWord& word, double now);
  void observe(const ServiceWord& word, double now);

  void find(const SessionNames& names, const Remedies& remedies, double now, Findings& found) const;

 private:
  struct Sender {
    Since since;
    int in_a_row = 0;
    double ahead = 0.0;  // s
    std::string channel;
    double heard = 0.0;  // a message from the future
  };
  struct Reader {
    std::string reason;
    Since since;
    double heard = 0.0;
  };

  ClockTroubleParameters parameters_;
  std::map<std::int64_t, Sender> senders_;  // by session: those ahead only
  std::map<std::string, Reader> readers_;   // by name: those that say so only
};

}  // namespace markservo::mmi
