#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

#include "services/mmi/troubles/robot_state.hpp"
#include "services/mmi/troubles/trouble_watch.hpp"

namespace markservo::mmi {

// Tells `troubles` and `state` what the message of `size` bytes at `data`, any bytes, says. `channel`: without a
// robot's prefix, any; one that is not in the table of channels tells nothing. `at`: us of the source's clock, when it
// was heard; `now`: s, as TroubleWatch has it. Returns why the message is none of its channel, or which rule it breaks:
// then it was not observed; empty if all is well. Of what does not tell of troubles, pictures among them, only type,
// session and time are read.
std::string observe_message(const std::string& channel, const void* data, std::size_t size, std::int64_t at, double now,
                            TroubleWatch& troubles, RobotState& state);

}  // namespace markservo::mmi
