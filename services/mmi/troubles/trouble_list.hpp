#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "services/mmi/troubles/finding.hpp"

namespace markservo::mmi {

// How long a sign must last until it is a trouble, and how long a trouble outlasts its last sign, so that none flashes.
// A trouble is to be shown within 1 s, and to be gone within 2 s.
struct TroubleListParameters {
  double end = 0.5;        // s, after the last sign
  double loss_end = 0.1;   // s, likewise of lost messages: their sign lasts until a service's next word, a second later
  double process = 0.5;    // s: what is killed once is running again by then
  double mark = 0.5;       // s: some frames without a mark are common; a task gives up after 1 s at the soonest
  double base = 0.4;       // s: a turn may find a way at once; a pose is found again by the next round of tags
  double recording = 0.7;  // s: where lcm-logger dies the recording goes on within 0.5 s
};

class TroubleList {
 public:
  explicit TroubleList(TroubleListParameters parameters = {}) : parameters_(parameters) {}

  // All signs at `now` (s), which does not go back. The troubles, the worst first, then the oldest; the same one
  // (identity_of) counts once.
  const std::vector<Trouble>& step(const Findings& findings, double now);

 private:
  struct Shown {
    Trouble trouble;
    double since = 0.0;  // s
    double last = 0.0;   // s, the last sign
  };

  double begin_of(TroubleCode code) const;
  double end_of(TroubleCode code) const;

  TroubleListParameters parameters_;
  std::map<std::pair<TroubleCode, std::string>, Shown> shown_;
  std::vector<Trouble> troubles_;
};

}  // namespace markservo::mmi
