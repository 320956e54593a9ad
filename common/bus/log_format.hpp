#pragma once

#include <string>

namespace markservo::bus {

// Gives this program's log its form: to the standard error, one line a call, with time, `name` and severity. What texts
// from the bus or a file bring into a line is made harmless here, once for all calls (common/text): no message can
// ring, colour, end a line or forge another.
void set_up_log(const std::string& name, const std::string& least_severity);

}  // namespace markservo::bus
