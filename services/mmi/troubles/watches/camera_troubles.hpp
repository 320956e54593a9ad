#pragma once

#include <optional>
#include <string>

#include "services/mmi/troubles/finding.hpp"
#include "services/mmi/troubles/known.hpp"
#include "services/mmi/troubles/remedies.hpp"
#include "services/mmi/troubles/session_names.hpp"
#include "services/mmi/troubles/words.hpp"

namespace markservo::mmi {

struct CameraTroubleParameters {
  double silent = 2.5;    // s without a picture: a loaded machine delays one by 1 to 2 s
  double patience = 3.0;  // s in which a reader may wait for its first: all are started at the same time
  double word = 3.0;      // s for which a service's word counts, of one a second
};

// camera_silent: STEREO_FRAME came and comes no more, or a service that reads it says that it gets none. Where only
// pictures are missing from what is heard here, as behind a bus-bridge or in a log without frames, its word counts.
class CameraTroubles {
 public:
  explicit CameraTroubles(CameraTroubleParameters parameters = {}) : parameters_(parameters) {}

  void observe(const AnyWord& word, double now);
  void observe(const ServiceWord& word, double now);

  void find(const SessionNames& names, const Remedies& remedies, double now, Findings& found) const;

 private:
  struct Reader {
    std::string name;
    std::string reason;  // why it does not work; empty while it gets its pictures
    bool has_had_one = false;
    Since since;  // with a reason
    double heard = 0.0;
  };
  struct Writer {
    std::string name;
    std::string reason;
    double heard = 0.0;
  };

  std::optional<Since> missing_since(double now) const;

  CameraTroubleParameters parameters_;
  std::optional<Since> picture_;  // the newest
  std::int64_t session_ = 0;      // its writer's
  std::optional<Reader> reader_;
  std::optional<Writer> writer_;  // the newest that spoke
};

}  // namespace markservo::mmi
