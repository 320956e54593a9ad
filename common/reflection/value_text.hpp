#pragma once

#include <string>
#include <vector>

#include "common/reflection/message_value.hpp"

namespace markservo::reflection {

// One plain value and where it stands in its message.
struct Leaf {
  std::string path;              // "marks[2].p_C.x"
  Value value;                   // no list, no fields
  const Field* field = nullptr;  // of its type; null where that is not told
};

// All plain values of a message, in order.
std::vector<Leaf> leaves(const Fields& fields);

// A plain value as text: numbers so that they read back to the same value, bytes by their number ("614400 bytes").
std::string text_of(const Value& value);

// The same of a value of `field`, but where a constant names it by that name: "LOCATED".
std::string text_of(const Field& field, const Value& value);

// A text from the bus or a log for a terminal, which control characters could command: all but printable ASCII is "?".
std::string printable(std::string text);

}  // namespace markservo::reflection
