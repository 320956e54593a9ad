#include "services/recorder/folder/last_event.hpp"

namespace markservo::recorder {
namespace {

// An event begins with this word, its number and its time, 4, 8 and 8 bytes, the largest first (LCM manual, "LCM Log
// File Format").
constexpr std::string_view kSyncWord = "\xED\xA1\xDA\x01";
constexpr std::size_t kTimeAt = 12;
constexpr std::size_t kTimeSize = 8;

// A log that holds more false ones than that at its end is not worth a longer search.
constexpr int kMostPlaces = 100;
constexpr std::int64_t kDay_us = 86'400'000'000;

std::int64_t time_at(std::string_view end, std::size_t place) {
  std::uint64_t time = 0;
  for (const char byte : end.substr(place + kTimeAt, kTimeSize)) time = time << 8 | static_cast<std::uint8_t>(byte);
  return static_cast<std::int64_t>(time);
}

}  // namespace

std::optional<std::int64_t> last_event_utime(std::string_view end, std::int64_t now_utime) {
  std::size_t place = end.rfind(kSyncWord);
  for (int tries = 0; tries < kMostPlaces && place != std::string_view::npos; ++tries) {
    if (end.size() - place >= kTimeAt + kTimeSize) {
      const std::int64_t utime = time_at(end, place);
      if (utime > now_utime - kDay_us && utime <= now_utime) return utime;
    }
    if (place == 0) break;
    place = end.rfind(kSyncWord, place - 1);
  }
  return std::nullopt;
}

std::int64_t missed_since(const std::vector<std::int64_t>& last_events, std::int64_t listens_since) {
  for (const std::int64_t utime : last_events) {
    if (utime > listens_since) return utime;
  }
  return listens_since;
}

}  // namespace markservo::recorder
