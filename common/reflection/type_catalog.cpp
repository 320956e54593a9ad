#include "common/reflection/type_catalog.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "common/reflection/lcm_language.hpp"
#include "common/reflection/our_types.hpp"

namespace markservo::reflection {
namespace {

// LCM 1.3.1, lcmgen.c: hash_update and hash_string_update; the shift to the right keeps the sign, and a text's length
// too is taken as a char.
std::uint64_t updated(std::uint64_t hash, signed char character) {
  const auto right = static_cast<std::uint64_t>(static_cast<std::int64_t>(hash) >> 55);
  return ((hash << 8) ^ right) + static_cast<std::uint64_t>(static_cast<std::int64_t>(character));
}

std::uint64_t updated(std::uint64_t hash, const std::string& text) {
  hash = updated(hash, static_cast<signed char>(text.size()));
  for (const char character : text) hash = updated(hash, static_cast<signed char>(character));
  return hash;
}

// lcmgen.c, lcm_enum_hash: only the name counts, so that values may be added.
std::uint64_t enum_hash(const MessageType& type) {
  return updated(0x87654321, type.name);
}

// lcmgen.c, lcm_struct_hash: neither the type's own name nor a nested type's is part of it.
std::uint64_t own_hash(const MessageType& type) {
  constexpr signed char kConstantSize = 0;
  constexpr signed char kVariableSize = 1;
  std::uint64_t hash = 0x12345678;
  for (const Field& field : type.fields) {
    hash = updated(hash, field.name);
    if (field.message == nullptr) hash = updated(hash, field.type_name);
    hash = updated(hash, static_cast<signed char>(field.dimensions.size()));
    for (const Dimension& dimension : field.dimensions) {
      hash = updated(hash, dimension.length_field < 0 ? kConstantSize : kVariableSize);
      hash = updated(hash, dimension.text);
    }
  }
  return hash;
}

// The generated _computeHash: nested fingerprints are added, a type within itself counts 0, the sum turns by one bit.
// An enumeration's own hash is all there is.
std::uint64_t whole_hash(const MessageType& type, std::vector<const MessageType*>& parents) {
  if (type.is_enum) return enum_hash(type);
  if (std::find(parents.begin(), parents.end(), &type) != parents.end()) return 0;
  parents.push_back(&type);
  std::uint64_t hash = own_hash(type);
  for (const Field& field : type.fields) {
    if (field.message != nullptr) hash += whole_hash(*field.message, parents);
  }
  parents.pop_back();
  return (hash << 1) + (hash >> 63);
}

TypeCatalog parse_ours() {
  std::vector<MessageType> types;
  for (const EmbeddedText& file : our_types()) {
    for (MessageType& type : parse_types(file.text, file.name)) types.push_back(std::move(type));
  }
  return TypeCatalog(std::move(types));
}

}  // namespace

const TypeCatalog& TypeCatalog::ours() {
  static const TypeCatalog catalog = parse_ours();
  return catalog;
}

TypeCatalog::TypeCatalog(std::vector<MessageType> types, const TypeCatalog* base) : base_(base) {
  for (MessageType& type : types) {
    const std::string name = type.full_name();
    if (!by_name_.emplace(name, std::make_unique<MessageType>(std::move(type))).second) {
      throw std::invalid_argument("type " + name + " is defined twice; allowed: once");
    }
  }
  for (const auto& [name, type] : by_name_) {
    for (Field& field : type->fields) {
      if (field.kind == Kind::kMessage) resolve(name, field);
    }
  }
  for (const auto& [name, type] : by_name_) {
    std::vector<const MessageType*> parents;
    type->fingerprint = whole_hash(*type, parents);
    by_fingerprint_.emplace(type->fingerprint, type.get());
  }
}

void TypeCatalog::resolve(const std::string& type_name, Field& field) const {
  field.message = find_full_name(field.type_name);
  if (field.message == nullptr) {
    throw std::invalid_argument("type " + type_name + ", field " + field.name + ": type " + field.type_name +
                                " is not defined");
  }
  if (!field.message->is_enum) return;
  field.kind = Kind::kEnum;
  field.value_names = field.message->fields.front().value_names;
}

const MessageType* TypeCatalog::find_full_name(const std::string& name) const {
  const auto found = by_name_.find(name);
  if (found != by_name_.end()) return found->second.get();
  return base_ == nullptr ? nullptr : base_->find_full_name(name);
}

const MessageType* TypeCatalog::find(std::uint64_t fingerprint) const {
  const auto found = by_fingerprint_.find(fingerprint);
  if (found != by_fingerprint_.end()) return found->second;
  return base_ == nullptr ? nullptr : base_->find(fingerprint);
}

const MessageType* TypeCatalog::find(const std::string& name) const {
  for (const auto& [full_name, type] : by_name_) {
    if (full_name == name || type->name == name) return type.get();
  }
  return base_ == nullptr ? nullptr : base_->find(name);
}

std::vector<const MessageType*> TypeCatalog::all() const {
  std::vector<const MessageType*> types;
  if (base_ != nullptr) types = base_->all();
  for (const auto& entry : by_name_) types.push_back(entry.second.get());
  return types;
}

std::string shown_name(const MessageType& type) {
  return type.package == kOurPackage ? type.name : type.full_name();
}

std::string fingerprint_text(std::uint64_t fingerprint) {
  return fmt::format("0x{:016x}", fingerprint);
}

}  // namespace markservo::reflection
