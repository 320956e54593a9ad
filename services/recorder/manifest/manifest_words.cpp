#include "services/recorder/manifest/manifest_words.hpp"

#include <spdlog/fmt/fmt.h>

#include <cmath>
#include <set>

namespace markservo::recorder {
namespace {

// `number` rounded to so many decimals, and no 0 at its end: "1.5", "2".
std::string rounded(double number, int decimals) {
  const double scale = std::pow(10.0, decimals);
  std::string text = fmt::format("{:.{}f}", std::round(number * scale) / scale, decimals);
  if (text.find('.') != std::string::npos) {
    text.erase(text.find_last_not_of('0') + 1);
    if (text.back() == '.') text.pop_back();
  }
  return text == "-0" ? "0" : text;
}

std::int64_t utime_of(const Json& moment) {
  return moment.is_object() ? moment.value("utime", std::int64_t{0}) : 0;
}

const Json& gaps_of(const Json& manifest) {
  static const Json kNone = Json::array();
  const auto gaps = manifest.find("gaps");
  return gaps != manifest.end() && gaps->is_array() ? *gaps : kNone;
}

double missing_s(const Json& manifest) {
  double seconds = 0.0;
  for (const Json& gap : gaps_of(manifest)) {
    const Json& to = gap.at("to").is_null() ? gap.at("from") : gap.at("to");
    seconds += 1e-6 * static_cast<double>(utime_of(to) - utime_of(gap.at("from")));
  }
  return seconds;
}

}  // namespace

std::string told_of_gaps(const Json& manifest) {
  std::set<std::string> reasons;
  for (const Json& gap : gaps_of(manifest)) reasons.insert(gap.value("reason", std::string()));
  std::string text;
  for (const std::string& reason : reasons) text += (text.empty() ? "" : ", ") + reason;
  return fmt::format("{} s are missing ({})", rounded(missing_s(manifest), 2), text);
}

std::string told_of_recording(const Json& manifest, const std::string& log_command) {
  const double seconds = 1e-6 * static_cast<double>(utime_of(manifest.at("end")) - utime_of(manifest.at("start")));
  double bytes = 0.0;
  const Json& parts = manifest.at("parts");
  for (const Json& part : parts) bytes += part.value("bytes", 0.0);
  std::string text =
      fmt::format("{} s, {} MB in {} file(s)", rounded(seconds, 1), rounded(1e-6 * bytes, 1), parts.size());
  if (!manifest.at("events").is_null()) {
    text += fmt::format(", {} messages on {} channels, {} lost", manifest.at("events").get<std::int64_t>(),
                        manifest.at("channels").size(), manifest.at("lost").get<std::int64_t>());
  } else {
    text += fmt::format(", not counted ({} info counts)", log_command);
  }
  if (!gaps_of(manifest).empty()) text += fmt::format(", not recorded for {} s", rounded(missing_s(manifest), 1));
  const auto damage = manifest.find("damage");
  if (damage != manifest.end() && !damage->empty()) {
    text += fmt::format(", torn at the end or damaged ({} info tells where)", log_command);
  }
  return text;
}

}  // namespace markservo::recorder
