#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <utility>

#include "services/mmi/troubles/finding.hpp"
#include "services/mmi/troubles/known.hpp"
#include "services/mmi/troubles/remedies.hpp"
#include "services/mmi/troubles/words.hpp"

namespace markservo::mmi {

struct ProcessTroubleParameters {
  double silent = 3.3;        // s without a word, of one a second: of a service, and of the stack's watch
  double silent_lossy = 6.0;  // s, likewise while messages get lost, words among them
};

// process_dead: the stack's watch says that it waits for its next start, ended by itself or cannot be started. Ends
// when it runs, or was told to stop. process_hung: the watch says that it runs and is silent, or a running one has
// fallen silent here; and the watch itself, of whose processes nothing is known then.
class ProcessTroubles {
 public:
  explicit ProcessTroubles(ProcessTroubleParameters parameters = {}) : parameters_(parameters) {}

  void observe(const ProcessWord& word, double now);
  void observe(const ServiceWord& word, double now);
  void observe(const AnyWord& word, double now);

  // `lossy`: messages get lost.
  void find(const Remedies& remedies, bool lossy, double now, Findings& found) const;

 private:
  enum class Condition { kWell, kSilent, kDead };
  using Place = std::pair<std::string, std::string>;  // host and name

  struct Process {
    ProcessWord word;
    Condition condition = Condition::kWell;
    Since since;  // in the condition
    double heard = 0.0;
  };
  struct Service {
    std::int64_t session = 0;
    int pid = 0;
    Since last;  // word, on whatever channel
    double heard = 0.0;
  };
  struct Watch {
    Since last;
    double heard = 0.0;
  };

  static Condition condition_of(ProcessState state);
  void note_watch(const std::string& host, std::int64_t at, double now);
  void find_process(const Process& process, const Remedies& remedies, double silent, double now, Findings& found) const;

  ProcessTroubleParameters parameters_;
  std::map<Place, Process> processes_;
  std::map<Place, Service> services_;
  std::map<std::int64_t, Place> speakers_;  // by session: of services_
  std::map<std::string, Watch> watches_;    // by host
};

}  // namespace markservo::mmi
