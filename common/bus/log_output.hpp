#pragma once

// A log that a service writes in place of speaking on a bus. Used by Connection.

#include <lcm/lcm-cpp.hpp>
#include <string>

#include "common/bus/outgoing.hpp"

namespace markservo::bus {

// Writes an LCM log whose events have the times of their messages. (liblcm's own file:// gives them the writer's clock:
// a video's frames then lie as close as they were computed, and a part of them cannot be cut out by time.)
class LogOutput {
 public:
  // Writes over what `path` holds. Throws BusUnavailable if it cannot be written.
  explicit LogOutput(const std::string& path);

  // False if the disk does not take it.
  bool write(const Outgoing& message);
  // Hands the disk what is still held back. False, and errno, if it does not take that.
  bool flush();

 private:
  lcm::LogFile file_;
};

}  // namespace markservo::bus
