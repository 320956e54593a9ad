#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "common/reflection/message_value.hpp"

namespace markservo::bus_top {

struct FieldLinesParameters {
  std::size_t numbers = 6;   // of an array of plain values, in one line: a joint vector whole
  std::size_t messages = 8;  // of an array of messages: as many marks as are seen at once
};

// A message as lines "name  value": what is nested is indented below its name, long arrays are shortened with their
// length said, bytes are their number. Texts are made printable.
std::vector<std::string> field_lines(const reflection::Fields& fields, const FieldLinesParameters& parameters = {});

}  // namespace markservo::bus_top
