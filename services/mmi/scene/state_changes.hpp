#pragma once

#include <cstddef>
#include <cstdint>
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
  };

  StateChanges() : StateChanges(Parameters{}) {}
  explicit StateChanges(const Parameters& parameters) : parameters_(parameters), requests_(parameters.requests_max) {}

  // The change that the report, heard at `at` (us), tells; nothing if it tells none.
  std::optional<StateChange> observe(const Report& report, std::int64_t at);

  // Numbers a change that somebody else has found, such as a trouble, with the others.
  StateChange tell(StateChange change);

  // Messages of writers that are not remembered since there are too many, and of which nothing is told.
  std::int64_t untold() const { return untold_; }

 private:
  // A kind, a key and the writer's session: all of a key stand together.
  using Writer = std::tuple<ChangeKind, std::string, std::int64_t>;
  struct Word {
    std::string state;
    std::string gist;
    std::int64_t heard = 0;  // us
  };

  std::optional<StateChange> compare(const Saying& saying, std::int64_t at);
  const Word* newest_of(ChangeKind kind, const std::string& key) const;
  // Forgets one of the kind that has been quiet, if there are too many. False: none has.
  bool make_room(ChangeKind kind, std::int64_t at);

  Parameters parameters_;
  std::map<Writer, Word> words_;
  RequestMemory requests_;
  std::int64_t number_ = 0;
  std::int64_t untold_ = 0;
};

}  // namespace markservo::mmi
