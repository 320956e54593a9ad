#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

#include "common/reflection/type_catalog.hpp"

namespace markservo::reflection {

// What one message on the bus tells a watcher.
struct MessageNote {
  std::size_t bytes = 0;                     // of the payload
  std::optional<std::uint64_t> fingerprint;  // none: fewer than 8 bytes
  std::string type;                          // as shown_name() has it; empty: the catalogue does not have it
  bool decodes = true;       // false: a type of the catalogue by its fingerprint, but broken; or too short
  std::int64_t session = 0;  // of the writer; 0: the type has none
  std::int64_t seq = -1;     // -1: the type has none
};

// What the `size` bytes at `data`, any bytes, tell by the types of `catalog`.
MessageNote note_of(const TypeCatalog& catalog, const void* data, std::size_t size);

}  // namespace markservo::reflection
