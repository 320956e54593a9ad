#pragma once

// The plain values of an encoded message, where they stand in its bytes: any one can be overwritten, whatever rule the
// message then breaks.

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "common/reflection/type_catalog.hpp"

namespace markservo::campaign {

struct LeafSpan {
  std::string path;  // "marks[2].p_C.x"
  std::string name;  // "x"
  reflection::Kind kind = reflection::Kind::kInt8;
  std::size_t offset = 0;  // of its first byte; of a text: of its 4 bytes of length
  std::size_t size = 0;    // bytes; of a text: with length and closing zero
  bool length = false;     // an array's
};

using Bytes = std::vector<std::uint8_t>;

// All of them, in order; empty where the bytes are no message of the catalogue.
std::vector<LeafSpan> leaf_spans(const reflection::TypeCatalog& catalog, const Bytes& message);

// An integer's or boolean's value.
std::int64_t integer_at(const Bytes& message, const LeafSpan& leaf);
double real_at(const Bytes& message, const LeafSpan& leaf);
void put_integer(Bytes& message, const LeafSpan& leaf, std::int64_t value);
void put_real(Bytes& message, const LeafSpan& leaf, double value);
// The message's later leaves move.
void put_text(Bytes& message, const LeafSpan& leaf, const std::string& text);

}  // namespace markservo::campaign
