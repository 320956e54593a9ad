#pragma once

// What a message type looks like, known at run time: for tools that show any channel, whatever it carries.

#include <cstdint>
#include <string>
#include <vector>

namespace markservo::reflection {

struct MessageType;

enum class Kind { kInt8, kInt16, kInt32, kInt64, kByte, kFloat, kDouble, kBoolean, kString, kMessage };

// One dimension of an array: as many elements as the number says, or as the earlier field at that place holds.
struct Dimension {
  std::string text;       // as written: "3" or "num_marks"
  std::int64_t size = 0;  // elements, where it is a number
  int length_field = -1;  // index among the type's fields; -1: `size` counts
};

struct Field {
  std::string name;
  std::string type_name;  // as written, a message's with its package
  Kind kind = Kind::kInt8;
  const MessageType* message = nullptr;  // of kMessage; set by TypeCatalog
  std::vector<Dimension> dimensions;     // empty: one value
  // Of 0, 1, 2 and so on: the constants that name this field's values; empty: none do.
  std::vector<std::string> value_names;
};

struct MessageType {
  std::string package;
  std::string name;  // without the package
  std::vector<Field> fields;
  std::uint64_t fingerprint = 0;  // the 8 bytes that its messages begin with; set by TypeCatalog

  std::string full_name() const { return package.empty() ? name : package + "." + name; }
};

}  // namespace markservo::reflection
