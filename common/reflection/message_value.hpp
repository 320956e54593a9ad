#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "common/reflection/type_catalog.hpp"

namespace markservo::reflection {

// An array of byte, as it stands in the message it was decoded from: it ends with that.
struct Bytes {
  const std::uint8_t* data = nullptr;
  std::size_t size = 0;
};

struct Value;
using List = std::vector<Value>;

// A message's fields, in the order of its type.
struct Fields {
  const MessageType* type = nullptr;
  std::vector<Value> values;  // one a field of the type

  const Value* find(const std::string& name) const;  // null: there is no such field
};

// One field's value: integers as int64, float as double, an array as a list (of lists), one of byte as Bytes.
struct Value {
  std::variant<std::int64_t, double, bool, std::string, Bytes, List, Fields> content;
};

struct DecodedMessage {
  std::string error;  // why the bytes are no message of the catalogue; empty when all is well
  Fields fields;
};

// The 8 bytes that name the type. False: fewer bytes than that.
bool read_fingerprint(const void* data, std::size_t size, std::uint64_t* fingerprint);

// Decodes any bytes: they give a message or a reason, never an exception, and no more memory than the bytes justify.
// All of `size` must be used. What is decoded refers to `data`, which must stay.
DecodedMessage decode(const TypeCatalog& catalog, const void* data, std::size_t size);

// The integer in `fields`, by its name; `otherwise` where there is none.
std::int64_t integer_in(const Fields& fields, const std::string& name, std::int64_t otherwise);

}  // namespace markservo::reflection
