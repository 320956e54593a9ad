#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "services/mmi/server/client_word.hpp"
#include "services/mmi/world/world_reader.hpp"

namespace markservo::mmi {

// What one client is shown: the bus, which all share, or a log at a time of the client's own.
class Shown {
 public:
  virtual ~Shown() = default;

  virtual WorldReader& world() = 0;
  // Grows when the world has been begun anew, at another time of a log.
  virtual std::uint64_t generation() { return 0; }
  // Time passes.
  virtual void advance(double /*now*/) {}
  // {"utime", "playing", "speed"} in JSON, of a log; empty live. Another version when it changed.
  virtual VersionedText play() { return {0, ""}; }
  // The frame to show; null: none.
  virtual std::shared_ptr<const Frame> picture() { return world().frames().ready(world().now()); }
  // Play, pause, seek, step: why it is refused; empty when it is done.
  virtual std::string control(const ClientWord& message) = 0;
  // The events that go with it.
  virtual const EventLog& events() = 0;
  // us, of the source.
  virtual std::int64_t utime() = 0;
};

}  // namespace markservo::mmi
