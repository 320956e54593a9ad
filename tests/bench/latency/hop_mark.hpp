#pragma once

// How the messages of empty processes name their frame: in their first bytes, by this host's byte order.

#include <cstdint>
#include <cstring>
#include <optional>

namespace markservo::bench {

using HopMark = std::int64_t;

// The mark of a message; nothing if it is too short for one.
inline std::optional<HopMark> hop_mark(const void* data, std::size_t size) {
  HopMark mark = 0;
  if (size < sizeof mark) return std::nullopt;
  std::memcpy(&mark, data, sizeof mark);
  return mark;
}

// `data`: at least as many bytes as a mark has.
inline void put_hop_mark(void* data, HopMark mark) {
  std::memcpy(data, &mark, sizeof mark);
}

}  // namespace markservo::bench
