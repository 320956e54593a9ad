#pragma once

#include <nlohmann/json.hpp>
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

// The message as JSON, bytes as {"bytes": number}; numbers that JSON cannot hold (NaN, infinite) as null.
nlohmann::ordered_json json_of(const Fields& fields);

// JSON as text, indented by `indent` (-1: one line); what is no UTF-8 in a name or text from elsewhere is replaced.
std::string json_text(const nlohmann::ordered_json& json, int indent = 2);

}  // namespace markservo::reflection
