#pragma once

#include <cstddef>
#include <limits>
#include <nlohmann/json.hpp>
#include <string>

#include "common/reflection/message_value.hpp"

namespace markservo::reflection {

enum class JsonForm {
  kShort,  // for people: integers as numbers, bytes as {"bytes": number}
  kExact,  // for JavaScript, whose numbers hold 53 bits: an int64_t as text, bytes as text in base64
};

// The message as JSON; numbers that JSON cannot hold (NaN, infinite) as null. An array of more than `most_bytes` bytes
// is told as in the short form, whatever the form.
nlohmann::ordered_json json_of(const Fields& fields, JsonForm form = JsonForm::kShort,
                               std::size_t most_bytes = std::numeric_limits<std::size_t>::max());

// JSON as text, indented by `indent` (-1: one line); what is no UTF-8 in a name or text from elsewhere is replaced.
std::string json_text(const nlohmann::ordered_json& json, int indent = 2);

}  // namespace markservo::reflection
