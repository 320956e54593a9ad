#pragma once

// Messages as the plain structs of reports.hpp.

#include <cstddef>
#include <cstdint>
#include <string>

#include "services/mmi/scene/reports.hpp"

namespace markservo::mmi {

struct ReadReport {
  Report report;
  std::string bad;  // why the bytes are no message of the channel, or which rule it breaks; then there is no report
};

// What the message on `channel`, without a robot's prefix, reports. Any bytes give a report or a reason; a channel that
// no view needs (pictures, unknown ones) neither, at once. STOP of kind STOP and TASK_COMMAND of kind ABORT, which are
// obeyed whatever else they say, are reported so.
ReadReport read_report(const std::string& channel, const void* data, std::size_t size);

}  // namespace markservo::mmi
