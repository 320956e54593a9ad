#pragma once

#include <map>
#include <string>
#include <utility>

#include "services/mmi/troubles/finding.hpp"
#include "services/mmi/troubles/known.hpp"
#include "services/mmi/troubles/remedies.hpp"
#include "services/mmi/troubles/words.hpp"

namespace markservo::mmi {

struct RecordingTroubleParameters {
  double silent = 3.3;  // s without a word, of one a second, from one that records: it was killed
};

// recording_ended: the newest recording has ended, or is interrupted, otherwise than it was told, or its recorder says
// nothing any more. Mended when one records again, that or another.
class RecordingTroubles {
 public:
  explicit RecordingTroubles(RecordingTroubleParameters parameters = {}) : parameters_(parameters) {}

  void observe(const RecorderWord& word, double now);

  void find(const Remedies& remedies, double now, Findings& found) const;

 private:
  struct Recording {
    RecorderWord word;
    Since since;  // recording, or not
    Since last;
    double heard = 0.0;
  };

  RecordingTroubleParameters parameters_;
  std::map<std::pair<std::string, std::string>, Recording> recordings_;  // by host and folder
};

}  // namespace markservo::mmi
