#pragma once

// What a message type looks like, known at run time: for tools that show any channel, whatever it carries.

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace markservo::reflection {

struct MessageType;

// An enumeration's value travels as an int32_t.
enum class Kind { kInt8, kInt16, kInt32, kInt64, kByte, kFloat, kDouble, kBoolean, kString, kEnum, kMessage };

// One dimension of an array: as many elements as the number says, or as the earlier field at that place holds.
struct Dimension {
  std::string text;       // as lcm-gen hashes it: "3", "0x3" or "num_marks"
  std::int64_t size = 0;  // elements, where it is a number
  int length_field = -1;  // index among the type's fields; -1: `size` counts
};

struct Field {
  std::string name;
  std::string type_name;  // as written, a message's with its package
  Kind kind = Kind::kInt8;
  const MessageType* message = nullptr;             // of kMessage and kEnum; set by TypeCatalog
  std::vector<Dimension> dimensions;                // empty: one value
  std::map<std::int64_t, std::string> value_names;  // the constants that name its values; empty: none do
};

struct MessageType {
  std::string package;
  std::string name;  // without the package
  std::vector<Field> fields;
  bool is_enum = false;           // then its one field is the value
  std::uint64_t fingerprint = 0;  // the 8 bytes that its messages begin with; set by TypeCatalog

  std::string full_name() const { return package.empty() ? name : package + "." + name; }
};

}  // namespace markservo::reflection
