#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <map>
#include <optional>
#include <string>
#include <tuple>

#include "services/mmi/scene/reports.hpp"
#include "services/mmi/scene/request_memory.hpp"
#include "services/mmi/scene/state_change.hpp"
#include "services/mmi/scene/state_sayings.hpp"

namespace markservo::mmi {

// Tells each change of state once, in the order of its hearing. What is remembered is bounded, whatever is sent.
//
// A state is its writer's: two that write as one are told with a change each, not with every message. A newcomer's
// first word is a change unless it repeats what the last of its name said; a service's always, since it has begun
// again. A reason's numbers may change unsaid. A request (STOP, TASK_COMMAND) is told when it is first heard.
class StateChanges {
 public:
  struct Parameters {
    std::size_t writers_max = 256;    // remembered of each kind: a stack has 12 services
    double quiet = 10.0;              // s without a word, after which one may be forgotten for a newcomer
    std::size_t requests_max = 1000;  // remembered; one is repeated for seconds
    std::size_t requests_told = 50;   // in each second, at most: who invents more is to push nothing else out
  };

  StateChanges() : StateChanges(Parameters{}) {}
  explicit StateChanges(const Parameters& parameters) : parameters_(parameters), requests_(parameters.requests_max) {}

  // The change that the report tells; nothing if it tells none. `at`: us, arrival; `now`: s of a clock that does not go
  // back.
  std::optional<StateChange> observe(const Report& report, std::int64_t at, double now);

  // Numbers a change that somebody else has found, such as a trouble, with the others.
  StateChange tell(StateChange change);

  // Messages of which nothing is told: of writers that are not remembered since there are too many, and requests beyond
  // the number that is told.
  std::int64_t untold() const { return untold_; }

 private:
  // A kind, a key and the writer's session: all of a key stand together.
  using Writer = std::tuple<ChangeKind, std::string, std::int64_t>;
  struct Word {
    std::string state;
    std::string gist;
    double heard = 0.0;  // s
  };

  std::optional<StateChange> compare(const Saying& saying, std::int64_t at, double now);
  bool may_tell_request(double now);
  const Word* newest_of(ChangeKind kind, const std::string& key) const;
  // Forgets one of the kind that has been quiet, if there are too many. False: none has.
  bool make_room(ChangeKind kind, double now);

  Parameters parameters_;
  std::map<Writer, Word> words_;
  RequestMemory requests_;
  std::deque<double> requests_told_;  // s, in the last second
  std::int64_t number_ = 0;
  std::int64_t untold_ = 0;
};

}  // namespace markservo::mmi
