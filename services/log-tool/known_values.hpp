#pragma once

#include "common/reflection/message_value.hpp"

namespace markservo::log_tool {

// Takes out of `fields` what another of a message's fields says is not known: the position of a mark that is not
// located, the strength of a read whose reader tells none; and what is 0 while it is not known: how far a goal is that
// nobody has measured the way to. A table or a plot would take the 0 for a measurement. It becomes an empty list, which
// has no leaves.
void leave_out_unknown(reflection::Fields& fields);

}  // namespace markservo::log_tool
