#include "tests/system/fault_campaign/words.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>

namespace markservo::campaign {
namespace {

// The code point at `at` and its bytes; nothing where it is no UTF-8.
struct Point {
  std::uint32_t value = 0;
  std::size_t size = 0;
};

std::optional<Point> point_at(const std::string& text, std::size_t at) {
  const auto byte = [&](std::size_t i) { return static_cast<std::uint32_t>(static_cast<unsigned char>(text[i])); };
  const std::uint32_t lead = byte(at);
  if (lead < 0x80) return Point{lead, 1};
  const std::size_t size = lead >= 0xf0 && lead < 0xf5   ? 4
                           : lead >= 0xe0 && lead < 0xf0 ? 3
                           : lead >= 0xc2 && lead < 0xe0 ? 2
                                                         : 0;
  if (size == 0 || at + size > text.size()) return std::nullopt;
  std::uint32_t value = lead & (0x7fU >> size);
  for (std::size_t i = 1; i < size; ++i) {
    if ((byte(at + i) & 0xc0U) != 0x80) return std::nullopt;
    value = value << 6 | (byte(at + i) & 0x3fU);
  }
  return Point{value, size};
}

bool is_control(std::uint32_t point) {
  if (point == '\n' || point == '\t') return false;
  return point < 0x20 || (point >= 0x7f && point < 0xa0) || point == 0x061c || point == 0x200e || point == 0x200f ||
         (point >= 0x202a && point <= 0x202e) || (point >= 0x2066 && point <= 0x2069);
}

std::string around(const std::string& text, std::size_t at) {
  constexpr std::size_t kBefore = 40;
  const std::size_t from = at > kBefore ? at - kBefore : 0;
  std::string shown = text.substr(from, 2 * kBefore);
  for (char& character : shown) {
    if (character < 0x20 || character > 0x7e) character = '?';
  }
  return shown;
}

}  // namespace

std::string unclean(const std::string& printed) {
  for (std::size_t at = 0; at < printed.size();) {
    const auto point = point_at(printed, at);
    if (!point)
      return text("byte 0x%02x at %zu is no UTF-8, in \"%s\"", static_cast<unsigned char>(printed[at]), at,
                  around(printed, at).c_str());
    if (is_control(point->value)) {
      return text("U+%04X at %zu, in \"%s\"", point->value, at, around(printed, at).c_str());
    }
    at += point->size;
  }
  return {};
}

}  // namespace markservo::campaign
