#pragma once

#include <optional>

#include "services/mmi/troubles/finding.hpp"
#include "services/mmi/troubles/known.hpp"
#include "services/mmi/troubles/remedies.hpp"
#include "services/mmi/troubles/words.hpp"

namespace markservo::mmi {

struct BaseTroubleParameters {
  double word = 2.0;  // s for which a ROBOT_POSE or BASE_STATUS counts, of some twenty a second
};

// pose_lost: the pose was known and is not to be trusted any more, or a drive waits for a pose. A robot that is still
// searching for its first one is in no trouble until then. base_blocked: something stands in a drive's way.
class BaseTroubles {
 public:
  explicit BaseTroubles(BaseTroubleParameters parameters = {}) : parameters_(parameters) {}

  void observe(const PoseWord& word, double now);
  void observe(const BaseWord& word, double now);

  void find(const Remedies& remedies, double now, Findings& found) const;

 private:
  template <class Word>
  struct Heard {
    std::optional<Word> word;
    Since since;  // in the state
    double heard = 0.0;

    void observe(const Word& newest, double now) {
      if (!word || word->state != newest.state) since = {now, newest.at};
      word = newest;
      heard = now;
    }
  };

  BaseTroubleParameters parameters_;
  Heard<PoseWord> pose_;
  Heard<BaseWord> base_;
};

}  // namespace markservo::mmi
