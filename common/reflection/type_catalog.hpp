#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "common/reflection/message_type.hpp"

namespace markservo::reflection {

inline constexpr const char* kOurPackage = "markservo";

// Message types by their fingerprint, which is all that a message says of its type.
class TypeCatalog {
 public:
  // All types of lcmtypes/, as they were when this was built.
  static const TypeCatalog& ours();

  // Resolves what `types` nest, among themselves and then in `base`, and computes the fingerprints as lcm-gen 1.3.1
  // does. All of `base` (null: nothing), which must outlive this, is found here too, after `types`: two versions of a
  // type may stand in both. Throws std::invalid_argument for a nested type that is not there, and for a type given
  // twice.
  explicit TypeCatalog(std::vector<MessageType> types, const TypeCatalog* base = nullptr);

  const MessageType* find(std::uint64_t fingerprint) const;  // null: not one of these
  const MessageType* find(const std::string& name) const;    // with or without the package
  std::vector<const MessageType*> all() const;               // by name, those of `base` first

 private:
  void resolve(const std::string& type_name, Field& field) const;
  const MessageType* find_full_name(const std::string& name) const;

  const TypeCatalog* base_;
  std::map<std::string, std::unique_ptr<MessageType>> by_name_;  // full names
  std::map<std::uint64_t, const MessageType*> by_fingerprint_;
};

// The name by which a person is told of it: one of ours without the package.
std::string shown_name(const MessageType& type);

// "0x0123456789abcdef".
std::string fingerprint_text(std::uint64_t fingerprint);

}  // namespace markservo::reflection
