#include "tests/system/fault_campaign/recording_scan.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
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

// What the manifest says of the recording: {"gaps": [[from, to], ...] in us, "ended_by"}, or {"error"}.
nlohmann::json scan_manifest(const std::string& path) {
  const auto manifest = nlohmann::json::parse(std::ifstream(path), nullptr, false);
  if (!manifest.is_object()) return {{"error", path + " cannot be read"}};
  nlohmann::json gaps = nlohmann::json::array();
  for (const auto& gap : manifest.value("gaps", nlohmann::json::array())) {
    const auto moment = [&](const char* name) {
      const auto found = gap.find(name);
      return found != gap.end() && found->is_object() ? found->value("utime", std::int64_t{0}) : std::int64_t{0};
    };
    gaps.push_back({moment("from"), moment("to")});
  }
  const auto ended = manifest.find("ended_by");
  const bool told = ended != manifest.end() && ended->is_string();
  return {{"gaps", gaps}, {"ended_by", told ? ended->get<std::string>() : std::string()}};
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
  scan["manifest"] = scan_manifest(folder + "/manifest.json");
  if (parts.empty()) scan["error"] = "there is no log in " + folder;
  return scan;
}

}  // namespace markservo::campaign
