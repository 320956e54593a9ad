#include "common/reflection/message_value.hpp"

#include <algorithm>
#include <cstring>
#include <stdexcept>

namespace markservo::reflection {
namespace {

constexpr int kDeepest = 32;  // types within types: a type may nest itself, a stack has an end

class Reader {
 public:
  Reader(const std::uint8_t* data, std::size_t size) : at_(data), left_(size) {}

  std::size_t left() const { return left_; }
  const std::uint8_t* take(std::size_t size) {
    if (size > left_) throw std::length_error("is truncated");
    const std::uint8_t* taken = at_;
    at_ += size;
    left_ -= size;
    return taken;
  }
  // Big-endian, as all of LCM's numbers.
  template <class Unsigned>
  Unsigned number() {
    const std::uint8_t* bytes = take(sizeof(Unsigned));
    std::uint64_t number = 0;
    for (std::size_t i = 0; i < sizeof(Unsigned); ++i) number = number << 8 | bytes[i];
    return static_cast<Unsigned>(number);
  }

 private:
  const std::uint8_t* at_;
  std::size_t left_;
};

template <class Real, class Unsigned>
double real(Reader& reader) {
  const auto bits = reader.number<Unsigned>();
  Real value;
  static_assert(sizeof value == sizeof bits);
  std::memcpy(&value, &bits, sizeof value);
  return static_cast<double>(value);
}

std::string text(Reader& reader) {
  const auto size = static_cast<std::int32_t>(reader.number<std::uint32_t>());
  if (size < 1) throw std::length_error("has a text of length " + std::to_string(size));
  const std::uint8_t* characters = reader.take(static_cast<std::size_t>(size));
  // The one zero byte of an honest text is its last.
  if (std::memchr(characters, 0, static_cast<std::size_t>(size)) != characters + size - 1) {
    throw std::length_error("has a text that does not end where it says");
  }
  return {characters, characters + size - 1};
}

// The fewest bytes that one value of the field takes.
std::size_t least_size(Kind kind) {
  switch (kind) {
    case Kind::kInt16:
      return 2;
    case Kind::kInt32:
    case Kind::kFloat:
    case Kind::kEnum:
      return 4;
    case Kind::kInt64:
    case Kind::kDouble:
      return 8;
    case Kind::kString:
      return 5;
    case Kind::kMessage:
      return 0;
    default:
      return 1;
  }
}

Fields read_fields(Reader& reader, const MessageType& type, int depth);

Value read_one(Reader& reader, const Field& field, int depth) {
  switch (field.kind) {
    case Kind::kInt8:
      return {std::int64_t{static_cast<std::int8_t>(reader.number<std::uint8_t>())}};
    case Kind::kInt16:
      return {std::int64_t{static_cast<std::int16_t>(reader.number<std::uint16_t>())}};
    case Kind::kInt32:
    case Kind::kEnum:
      return {std::int64_t{static_cast<std::int32_t>(reader.number<std::uint32_t>())}};
    case Kind::kInt64:
      return {static_cast<std::int64_t>(reader.number<std::uint64_t>())};
    case Kind::kByte:
      return {std::int64_t{reader.number<std::uint8_t>()}};
    case Kind::kBoolean:
      return {reader.number<std::uint8_t>() != 0};
    case Kind::kFloat:
      return {real<float, std::uint32_t>(reader)};
    case Kind::kDouble:
      return {real<double, std::uint64_t>(reader)};
    case Kind::kString:
      return {text(reader)};
    case Kind::kMessage:
      break;
  }
  return {read_fields(reader, *field.message, depth + 1)};
}

std::size_t elements(const Field& field, const Dimension& dimension, const Fields& earlier, std::size_t left) {
  std::int64_t size = dimension.size;
  if (dimension.length_field >= 0) {
    size = std::get<std::int64_t>(earlier.values[static_cast<std::size_t>(dimension.length_field)].content);
  }
  // A type without fields takes no bytes; more of them than bytes are left is still no honest message.
  const std::size_t least = std::max<std::size_t>(least_size(field.kind), 1);
  if (size < 0 || static_cast<std::uint64_t>(size) > left / least) {
    throw std::length_error("has " + std::to_string(size) + " elements in " + field.name);
  }
  return static_cast<std::size_t>(size);
}

Value read_array(Reader& reader, const Field& field, std::size_t dimension, const Fields& earlier, int depth) {
  const std::size_t size = elements(field, field.dimensions[dimension], earlier, reader.left());
  const bool innermost = dimension + 1 == field.dimensions.size();
  if (innermost && field.kind == Kind::kByte) return {Bytes{reader.take(size), size}};
  List list;
  list.reserve(size);
  for (std::size_t i = 0; i < size; ++i) {
    list.push_back(innermost ? read_one(reader, field, depth)
                             : read_array(reader, field, dimension + 1, earlier, depth));
  }
  return {std::move(list)};
}

Fields read_fields(Reader& reader, const MessageType& type, int depth) {
  if (depth > kDeepest) throw std::length_error("nests more than " + std::to_string(kDeepest) + " types");
  Fields fields;
  fields.type = &type;
  fields.values.reserve(type.fields.size());
  for (const Field& field : type.fields) {
    fields.values.push_back(field.dimensions.empty() ? read_one(reader, field, depth)
                                                     : read_array(reader, field, 0, fields, depth));
  }
  return fields;
}

}  // namespace

const Value* Fields::find(const std::string& name) const {
  for (std::size_t i = 0; type != nullptr && i < type->fields.size(); ++i) {
    if (type->fields[i].name == name) return &values[i];
  }
  return nullptr;
}

bool read_fingerprint(const void* data, std::size_t size, std::uint64_t* fingerprint) {
  Reader reader(static_cast<const std::uint8_t*>(data), size);
  if (reader.left() < sizeof *fingerprint) return false;
  *fingerprint = reader.number<std::uint64_t>();
  return true;
}

DecodedMessage decode(const TypeCatalog& catalog, const void* data, std::size_t size) {
  DecodedMessage message;
  std::uint64_t fingerprint = 0;
  if (!read_fingerprint(data, size, &fingerprint)) {
    message.error = "message of " + std::to_string(size) + " bytes is shorter than a type's fingerprint";
    return message;
  }
  const MessageType* type = catalog.find(fingerprint);
  if (type == nullptr) {
    message.error = "unknown type " + fingerprint_text(fingerprint);
    return message;
  }
  Reader reader(static_cast<const std::uint8_t*>(data) + sizeof fingerprint, size - sizeof fingerprint);
  try {
    message.fields = read_fields(reader, *type, 0);
    if (reader.left() > 0) message.error = type->name + " has " + std::to_string(reader.left()) + " bytes too many";
  } catch (const std::length_error& error) {
    message.error = type->name + " " + error.what();
  }
  return message;
}

std::int64_t integer_in(const Fields& fields, const std::string& name, std::int64_t otherwise) {
  const Value* value = fields.find(name);
  const auto* number = value == nullptr ? nullptr : std::get_if<std::int64_t>(&value->content);
  return number == nullptr ? otherwise : *number;
}

}  // namespace markservo::reflection
