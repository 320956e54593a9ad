#include "common/bus/safe_decode.hpp"

#include <fmt/format.h>
#include <lcm/lcm_coretypes.h>

#include <cstdint>
#include <limits>

namespace markservo::bus {

std::string other_version_text(const char* type, std::int64_t theirs, std::int64_t ours) {
  return fmt::format(
      "message is of another version of {} or of another type: its fingerprint is 0x{:016x}, here it is 0x{:016x}",
      type, static_cast<std::uint64_t>(theirs), static_cast<std::uint64_t>(ours));
}

std::string why_not_of(const char* type, std::int64_t ours, const void* data, std::size_t size) {
  constexpr std::size_t kHashSize = 8;
  if (size < kHashSize) return "message of " + std::to_string(size) + " bytes is shorter than a type's fingerprint";
  if (size > static_cast<std::size_t>(std::numeric_limits<int>::max())) return "message is larger than 2 GiB";
  std::int64_t fingerprint = 0;
  __int64_t_decode_array(data, 0, static_cast<int>(kHashSize), &fingerprint, 1);
  return fingerprint == ours ? std::string() : other_version_text(type, fingerprint, ours);
}

std::string why_not_decoded(const char* type, int used, std::size_t size) {
  if (used < 0) return std::string(type) + " is truncated or has an impossible length";
  if (static_cast<std::size_t>(used) == size) return {};
  return std::string(type) + " has " + std::to_string(size - static_cast<std::size_t>(used)) + " bytes too many";
}

std::string why_not_decoded(const char* type, const std::exception& error) {
  return std::string(type) + " cannot be decoded: " + error.what();
}

}  // namespace markservo::bus
