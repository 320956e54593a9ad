#pragma once

// The story of a robot, as its messages tell it: changes of state and troubles, one after the other.

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>

#include "common/robot/robot_description.hpp"
#include "common/text/typed_command.hpp"
#include "services/mmi/scene/scene_messages.hpp"
#include "services/mmi/scene/state_changes.hpp"
#include "services/mmi/troubles/robot_state.hpp"
#include "services/mmi/troubles/trouble_watch.hpp"
#include "services/mmi/world/event_log.hpp"

namespace markservo::mmi {

class NarratorReader {
 public:
  struct Parameters {
    std::size_t events = 2000;    // kept: minutes of a busy robot, for who comes late or falls behind
    double troubles_every = 0.1;  // s
    text::TypedCommand typed;     // as what a person knows the commands that mend
  };

  explicit NarratorReader(const robot::RobotDescription& robot) : NarratorReader(robot, Parameters{}) {}
  NarratorReader(const robot::RobotDescription& robot, const Parameters& parameters);

  // Takes a message in, any bytes; gives what it reports, for who draws it, or why it counts for nothing. `channel`:
  // without a robot's prefix; `at`: us, arrival; `now`: s of a clock that does not go back.
  ReadReport observe(const std::string& channel, const void* data, std::size_t size, std::int64_t at, double now);
  // Time passes; `at` (us) is what the source's clock shows.
  void advance(std::int64_t at, double now);

  const EventLog& events() const { return events_; }
  // Messages of which nothing is told, for there are too many of their kind.
  std::int64_t untold() const { return changes_.untold(); }
  const RobotState& state() const { return state_; }
  // The present ones, the worst first; `version` grows with each change.
  const std::vector<Trouble>& troubles() const { return troubles_; }
  std::uint64_t version() const { return version_; }

 private:
  void compare(std::int64_t at, const std::vector<Trouble>& now);

  Parameters parameters_;
  StateChanges changes_;
  TroubleWatch watch_;
  RobotState state_;
  EventLog events_;
  std::vector<Trouble> troubles_;
  std::uint64_t version_ = 0;
  std::optional<double> judged_;  // s
};

}  // namespace markservo::mmi
