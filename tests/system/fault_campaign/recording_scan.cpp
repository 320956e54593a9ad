#include "tests/system/fault_campaign/recording_scan.hpp"

#include <algorithm>
#include <filesystem>
#include <lcm/lcm-cpp.hpp>
#include <set>
#include <vector>

namespace markservo::campaign {
namespace {

constexpr std::int64_t kMoment_us = 100'000;

void scan_part(const std::string& path, std::set<std::int64_t>& moments, std::int64_t& events) {
  lcm::LogFile log(path, "r");
  if (!log.good()) return;
  // After a damaged place the next event is found again.
  constexpr int kMostDamages = 1000;
  for (int damages = 0; damages < kMostDamages; ++damages) {
    while (const lcm::LogEvent* event = log.readNextEvent()) {
      moments.insert(event->timestamp / kMoment_us * kMoment_us);
      ++events;
    }
    if (std::feof(log.getFilePtr()) != 0) return;
  }
}

}  // namespace

nlohmann::json scan_recording(const std::string& folder) {
  std::vector<std::string> parts;
  std::error_code error;
  for (const auto& entry : std::filesystem::directory_iterator(folder, error)) {
    if (entry.path().filename().string().rfind("log.lcm", 0) == 0) parts.push_back(entry.path());
  }
  std::sort(parts.begin(), parts.end());
  std::set<std::int64_t> moments;
  std::int64_t events = 0;
  for (const std::string& part : parts) scan_part(part, moments, events);
  nlohmann::json scan{{"parts", parts.size()}, {"events", events}, {"moments", moments}};
  if (parts.empty()) scan["error"] = "there is no log in " + folder;
  return scan;
}

}  // namespace markservo::campaign
