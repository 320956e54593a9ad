#include "tests/system/fault_campaign/message_leaves.hpp"

#include <cstring>
#include <map>
#include <stdexcept>

#include "common/reflection/message_value.hpp"

namespace markservo::campaign {
namespace {

using reflection::Kind;

std::uint64_t read(const Bytes& bytes, std::size_t offset, std::size_t size) {
  std::uint64_t number = 0;
  for (std::size_t i = 0; i < size; ++i) number = number << 8 | bytes.at(offset + i);
  return number;
}

void write(Bytes& bytes, std::size_t offset, std::size_t size, std::uint64_t number) {
  for (std::size_t i = 0; i < size; ++i)
    bytes.at(offset + i) = static_cast<std::uint8_t>(number >> (8 * (size - 1 - i)));
}

std::size_t size_of(Kind kind) {
  switch (kind) {
    case Kind::kInt16:
      return 2;
    case Kind::kInt32:
    case Kind::kFloat:
      return 4;
    case Kind::kInt64:
    case Kind::kDouble:
      return 8;
    default:
      return 1;
  }
}

class Walker {
 public:
  Walker(const Bytes& message, std::vector<LeafSpan>& leaves) : message_(message), leaves_(leaves) {}

  void walk(const reflection::MessageType& type, const std::string& prefix) {
    std::map<int, std::int64_t> integers;  // by the field's place: arrays' lengths
    std::vector<bool> is_length(type.fields.size());
    for (const auto& field : type.fields) {
      for (const auto& dimension : field.dimensions) {
        if (dimension.length_field >= 0) is_length.at(static_cast<std::size_t>(dimension.length_field)) = true;
      }
    }
    for (std::size_t i = 0; i < type.fields.size(); ++i) {
      const auto& field = type.fields[i];
      const std::string path = prefix + field.name;
      if (!field.dimensions.empty()) {
        array(field, 0, path, integers);
        continue;
      }
      one(field, path, is_length[i]);
      if (is_length[i]) integers[static_cast<int>(i)] = integer_at(message_, leaves_.back());
    }
  }
  std::size_t offset() const { return offset_; }
  void skip(std::size_t bytes) { offset_ += bytes; }

 private:
  void array(const reflection::Field& field, std::size_t dimension, const std::string& path,
             const std::map<int, std::int64_t>& integers) {
    const auto& extent = field.dimensions[dimension];
    const std::int64_t count = extent.length_field >= 0 ? integers.at(extent.length_field) : extent.size;
    if (field.kind == Kind::kByte && dimension + 1 == field.dimensions.size()) {
      skip(static_cast<std::size_t>(count));
      return;
    }
    for (std::int64_t i = 0; i < count; ++i) {
      const std::string element = path + "[" + std::to_string(i) + "]";
      if (dimension + 1 < field.dimensions.size()) {
        array(field, dimension + 1, element, integers);
      } else {
        one(field, element, false);
      }
    }
  }

  void one(const reflection::Field& field, const std::string& path, bool length) {
    if (field.kind == Kind::kMessage) {
      walk(*field.message, path + ".");
      return;
    }
    std::size_t size = size_of(field.kind);
    if (field.kind == Kind::kString) size = 4 + read(message_, offset_, 4);
    leaves_.push_back({path, field.name, field.kind, offset_, size, length});
    offset_ += size;
  }

  const Bytes& message_;
  std::vector<LeafSpan>& leaves_;
  std::size_t offset_ = 0;
};

}  // namespace

std::vector<LeafSpan> leaf_spans(const reflection::TypeCatalog& catalog, const Bytes& message) {
  std::vector<LeafSpan> leaves;
  if (!reflection::decode(catalog, message.data(), message.size()).error.empty()) return leaves;
  std::uint64_t fingerprint = 0;
  reflection::read_fingerprint(message.data(), message.size(), &fingerprint);
  Walker walker(message, leaves);
  walker.skip(sizeof fingerprint);
  walker.walk(*catalog.find(fingerprint), "");
  if (walker.offset() != message.size()) throw std::logic_error("leaf_spans: the message was not walked to its end");
  return leaves;
}

std::int64_t integer_at(const Bytes& message, const LeafSpan& leaf) {
  const std::uint64_t bits = read(message, leaf.offset, leaf.size);
  const unsigned shift = 8 * static_cast<unsigned>(sizeof bits - leaf.size);
  return static_cast<std::int64_t>(bits << shift) >> shift;
}

double real_at(const Bytes& message, const LeafSpan& leaf) {
  const std::uint64_t bits = read(message, leaf.offset, leaf.size);
  if (leaf.kind == Kind::kFloat) {
    const auto narrow = static_cast<std::uint32_t>(bits);
    float value = 0.0F;
    std::memcpy(&value, &narrow, sizeof value);
    return static_cast<double>(value);
  }
  double value = 0.0;
  std::memcpy(&value, &bits, sizeof value);
  return value;
}

void put_integer(Bytes& message, const LeafSpan& leaf, std::int64_t value) {
  write(message, leaf.offset, leaf.size, static_cast<std::uint64_t>(value));
}

void put_real(Bytes& message, const LeafSpan& leaf, double value) {
  if (leaf.kind == Kind::kFloat) {
    const auto narrow = static_cast<float>(value);
    std::uint32_t bits = 0;
    std::memcpy(&bits, &narrow, sizeof bits);
    write(message, leaf.offset, leaf.size, bits);
    return;
  }
  std::uint64_t bits = 0;
  std::memcpy(&bits, &value, sizeof bits);
  write(message, leaf.offset, leaf.size, bits);
}

void put_text(Bytes& message, const LeafSpan& leaf, const std::string& text) {
  Bytes replacement(4 + text.size() + 1);
  write(replacement, 0, 4, text.size() + 1);
  std::memcpy(replacement.data() + 4, text.c_str(), text.size() + 1);
  const auto at = message.begin() + static_cast<std::ptrdiff_t>(leaf.offset);
  const auto after = message.erase(at, at + static_cast<std::ptrdiff_t>(leaf.size));
  message.insert(after, replacement.begin(), replacement.end());
}

}  // namespace markservo::campaign
