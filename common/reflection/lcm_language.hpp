#pragma once

#include <string>
#include <vector>

#include "common/reflection/message_type.hpp"

namespace markservo::reflection {

// The message types that a text in LCM's type language defines, in its order, as lcm-gen takes them (the language:
// LCM's "Type Specification Language" manual page; struct, enum, const, arrays, nested types). An array's size is a
// number, decimal, hexadecimal or octal, a constant of the type (lcm-gen from 1.4 on) or an integer field before it.
// Nested types are named, not resolved. Throws std::invalid_argument with `origin`, line, what and what is allowed.
//
// Constants are no part of the language's fields. Here each row of them that counts 0, 1, 2, ... names the values of
// one int8_t field: the first row of the type's first such field, and so on.
std::vector<MessageType> parse_types(const std::string& text, const std::string& origin);

}  // namespace markservo::reflection
