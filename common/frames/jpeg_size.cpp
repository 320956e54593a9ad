#include "common/frames/jpeg_size.hpp"

#include <cstddef>

namespace markservo::frames {
namespace {

constexpr std::uint8_t kMarkerPrefix = 0xFF;
constexpr std::uint8_t kStartOfImage = 0xD8;
constexpr std::uint8_t kStartOfScan = 0xDA;
constexpr std::uint8_t kEndOfImage = 0xD9;
constexpr std::uint8_t kFirstRestart = 0xD0;
constexpr std::uint8_t kTemporary = 0x01;

// C0 to CF begin a frame, but for DHT (C4), JPG (C8) and DAC (CC).
bool begins_frame(std::uint8_t marker) {
  return marker >= 0xC0 && marker <= 0xCF && marker != 0xC4 && marker != 0xC8 && marker != 0xCC;
}

// Markers that carry no segment or begin the scan: none of them may come before the frame header.
bool out_of_place(std::uint8_t marker) {
  return marker == 0x00 || marker == kTemporary || (marker >= kFirstRestart && marker <= kEndOfImage) ||
         marker == kStartOfScan;
}

}  // namespace

std::optional<JpegSize> jpeg_size(const std::vector<std::uint8_t>& bytes) {
  const auto word = [&bytes](std::size_t at) { return 256 * bytes[at] + bytes[at + 1]; };
  if (bytes.size() < 2 || bytes[0] != kMarkerPrefix || bytes[1] != kStartOfImage) return std::nullopt;
  std::size_t at = 2;
  while (true) {
    if (at >= bytes.size() || bytes[at] != kMarkerPrefix) return std::nullopt;
    while (at < bytes.size() && bytes[at] == kMarkerPrefix) ++at;  // a marker may be preceded by fill bytes
    if (at >= bytes.size() || out_of_place(bytes[at])) return std::nullopt;
    const std::uint8_t marker = bytes[at++];
    if (bytes.size() - at < 2) return std::nullopt;
    const auto length = static_cast<std::size_t>(word(at));  // counts its own two bytes
    if (length < 2 || bytes.size() - at < length) return std::nullopt;
    if (begins_frame(marker)) {
      // Length, sample precision, height, width.
      if (length < 7) return std::nullopt;
      const JpegSize size{word(at + 5), word(at + 3)};
      if (size.width == 0 || size.height == 0) return std::nullopt;
      return size;
    }
    at += length;
  }
}

}  // namespace markservo::frames
