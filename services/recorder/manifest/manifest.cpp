#include "services/recorder/manifest/manifest.hpp"

#include <spdlog/fmt/chrono.h>
#include <spdlog/fmt/fmt.h>

namespace markservo::recorder {
namespace {

constexpr int kFormatVersion = 1;
constexpr std::size_t kMostGaps = 1000;  // some 200 kB of text

Json or_null(const std::optional<std::int64_t>& number) {
  return number ? Json(*number) : Json();
}

// Of `name` in each element of `list`; null counts as 0.
std::int64_t sum(const Json& list, const char* name) {
  std::int64_t total = 0;
  for (const Json& element : list) {
    const auto found = element.find(name);
    if (found != element.end() && found->is_number()) total += found->get<std::int64_t>();
  }
  return total;
}

bool is_instant(const Json& json) {
  return json.is_object() && json.contains("utime") && json.at("utime").is_number_integer();
}

Json damage_of(const Json& files) {
  Json all = Json::array();
  for (const Json& file : files) {
    const std::string path = file.at("path").get<std::string>();
    for (const Json& damage : file.value("damage", Json::array())) {
      all.push_back({{"file", path.substr(path.rfind('/') + 1)},
                     {"offset", damage.value("offset", Json())},
                     {"bytes", damage.value("bytes", Json())}});
    }
  }
  return all;
}

}  // namespace

Json instant(std::int64_t utime) {
  const auto second = static_cast<std::time_t>(utime / 1'000'000);
  return {{"utc", fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(second))}, {"utime", utime}};
}

Json begun_manifest(const ManifestBeginning& beginning, const RecordingPlan& plan) {
  return {{"format_version", kFormatVersion},
          {"name", beginning.name},
          {"note", plan.note},
          {"start", instant(beginning.start_utime)},
          {"end", nullptr},
          {"ended_by", nullptr},
          {"host", beginning.host},
          {"lcm_url", plan.lcm_url},
          {"robot", plan.robot},
          {"lcm_version", beginning.lcm_version},
          {"source", beginning.source},
          {"with_frames", plan.frames},
          {"split_mb", or_null(plan.split_mb)},
          {"keep_parts", or_null(plan.keep_parts)},
          {"min_free_mb", plan.min_free_mb},
          {"types", beginning.types},
          {"configuration", beginning.configuration},
          {"logger", nullptr},
          {"parts", Json::array()},
          {"parts_removed", 0},
          {"events", nullptr},
          {"lost", nullptr},
          {"damage", nullptr},
          {"channels", nullptr},
          {"gaps", Json::array()}};
}

bool is_manifest(const Json& json) {
  if (!json.is_object() || !json.contains("format_version") || !json.contains("end")) return false;
  const Json& end = json.at("end");
  return is_instant(json.value("start", Json())) && (end.is_null() || is_instant(end));
}

bool is_complete(const Json& manifest) {
  return !manifest.at("end").is_null();
}

void begin_gap(Json* manifest, std::int64_t from_utime, const LoggerEnd& logger, const std::string& reason) {
  Json& gaps = (*manifest)["gaps"];
  if (gaps.size() >= kMostGaps) {
    gaps.back()["to"] = nullptr;
    gaps.back()["times"] = gaps.back()["times"].get<std::int64_t>() + 1;
    return;
  }
  gaps.push_back({{"from", instant(from_utime)},
                  {"to", nullptr},
                  {"exit_code", logger.exit_code()},
                  {"signal", logger.by_signal ? Json(logger.number) : Json()},
                  {"reason", reason},
                  {"times", 1}});
}

void end_gap(Json* manifest, std::int64_t to_utime) {
  (*manifest)["gaps"].back()["to"] = instant(to_utime);
}

void complete(Json* manifest, const ManifestEnd& end) {
  const Json ended = instant(end.utime);
  Json& gaps = (*manifest)["gaps"];
  if (!gaps.is_array()) gaps = Json::array();
  for (Json& gap : gaps) {
    if (gap.value("to", Json()).is_null()) gap["to"] = ended;
  }
  (*manifest)["end"] = ended;
  (*manifest)["ended_by"] = end.ended_by;
  (*manifest)["logger"] = {{"exit_code", end.logger_exit_code ? Json(*end.logger_exit_code) : Json()},
                           {"said", end.logger_said}};
  Json parts = Json::array();
  for (const Part& part : end.parts) parts.push_back({{"file", part.name}, {"bytes", part.bytes}});
  (*manifest)["parts"] = parts;
  (*manifest)["parts_removed"] = end.parts_removed;
  if (!end.found.is_object()) return;
  const Json channels = end.found.value("channels", Json::array());
  (*manifest)["channels"] = channels;
  (*manifest)["events"] = sum(channels, "events");
  (*manifest)["lost"] = sum(channels, "lost");
  (*manifest)["damage"] = damage_of(end.found.value("files", Json::array()));
}

Json nothing_found() {
  return {{"files", Json::array()}, {"channels", Json::array()}};
}

std::string manifest_text(const Json& manifest) {
  return manifest.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace markservo::recorder
