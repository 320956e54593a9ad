#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <utility>

#include "services/mmi/troubles/finding.hpp"
#include "services/mmi/troubles/known.hpp"
#include "services/mmi/troubles/remedies.hpp"
#include "services/mmi/troubles/session_names.hpp"
#include "services/mmi/troubles/words.hpp"

namespace markservo::mmi {

struct WriterTroubleParameters {
  double alone = 1.0;  // s without another's word after which one writes alone again; goals come each 0.2 s
  int turns = 3;  // so often one must speak again after the other: twice, where one had a message under way at its end
  double word = 2.5;  // s for which a service's word counts, of one a second
};

// second_writer: two sessions take turns on a channel, or for a stop device, that one shall write. A restart is one
// turn and no trouble. Of a channel that is not heard here at all, as pictures behind a bus-bridge, the word of the
// services that read it counts.
class WriterTroubles {
 public:
  explicit WriterTroubles(WriterTroubleParameters parameters = {}) : parameters_(parameters) {}

  void observe(const AnyWord& word, double now);
  void observe(const ServiceWord& word, double now);

  void find(const SessionNames& names, const Remedies& remedies, double now, Findings& found) const;

 private:
  struct Output {
    std::int64_t session = 0;  // spoke last
    double heard = 0.0;
    std::int64_t other = 0;  // spoke before it; 0: none did
    double other_heard = 0.0;
    int turns = 0;  // how often one of both spoke again after the other
    Since since;    // the first of these
  };
  struct Told {
    std::string reader;
    Since since;
    double heard = 0.0;
  };

  bool two_write(const Output& output, double now) const;

  WriterTroubleParameters parameters_;
  std::map<std::pair<std::string, std::string>, Output> outputs_;  // by channel and writer_of
  std::map<std::string, Told> told_;                               // by channel
};

}  // namespace markservo::mmi
