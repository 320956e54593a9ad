#include "services/log-tool/info_report.hpp"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <algorithm>

#include "common/logs/bus_limits.hpp"
#include "common/reflection/type_catalog.hpp"
#include "common/reflection/value_text.hpp"
#include "services/log-tool/play_choice.hpp"

namespace markservo::log_tool {
namespace {

std::string size_text(std::int64_t bytes) {
  const double size = static_cast<double>(bytes);
  if (size < 1e3) return fmt::format("{} B", bytes);
  if (size < 1e6) return fmt::format("{:.1f} kB", size / 1e3);
  if (size < 1e9) return fmt::format("{:.1f} MB", size / 1e6);
  return fmt::format("{:.2f} GB", size / 1e9);
}

std::string type_text(const ChannelSummary& channel) {
  return channel.type.empty() ? reflection::fingerprint_text(channel.fingerprint) : channel.type;
}

std::string notes(const ChannelSummary& channel) {
  std::string text;
  const auto add = [&text](std::int64_t count, const char* what) {
    if (count > 0) text += fmt::format("{}{} {}", text.empty() ? "" : ", ", count, what);
  };
  add(channel.undecodable, "cannot be decoded");
  add(channel.too_large, "too large");
  add(channel.other_types, "of another type");
  add(channel.time_reversals, "back in time");
  if (channel.sessions > 1) add(channel.sessions, "sessions");
  return text;
}

// What the table's words mean, of those that are in it.
std::string legend(const LogSummary& summary) {
  const auto any = [&summary](auto has) { return std::any_of(summary.channels.begin(), summary.channels.end(), has); };
  std::string text;
  if (any([](const ChannelSummary& channel) { return channel.lost.value_or(0) > 0; })) {
    text += "lost: missing in the numbers that each session counts; the recorder did not hear them, others may have\n";
  }
  if (any([](const ChannelSummary& channel) { return channel.sessions > 1; })) {
    text += "sessions: writers of the channel, each start of one is another\n";
  }
  if (any([](const ChannelSummary& channel) { return channel.time_reversals > 0; })) {
    text += "back in time: messages of a session with an earlier time (utime) than the one before\n";
  }
  if (any([](const ChannelSummary& channel) { return channel.too_large > 0; })) {
    text +=
        fmt::format("too large: messages above {:.0f} MB, which a bus by UDP loses; a replay to it leaves them out\n",
                    1e-6 * logs::kLargestByUdp);
  }
  if (any([](const ChannelSummary& channel) { return channel.type.empty() && channel.channel != kLcmSelfTest; })) {
    text += "0x...: a type that is not known; --types FILE.lcm... tells it\n";
  }
  return text.empty() ? text : "\n" + text;
}

// What of the log's time a replay makes something of.
std::string time_text(const TimeSteps& steps) {
  std::string text;
  if (steps.farthest_back > kDisorder_s) {
    text += "time goes " + disorder_text(steps) + "; a replay keeps the log's order (--sort: by time)\n";
  }
  if (!steps.silences.empty()) {
    text += "silent: " + silences_text(steps) + "; a replay waits as long (--longest-gap S: no longer than that)\n";
  }
  return text;
}

nlohmann::ordered_json silences_json(const std::vector<Silence>& silences) {
  constexpr std::size_t kMost = 1000;
  auto json = nlohmann::ordered_json::array();
  for (const Silence& silence : silences) {
    if (json.size() < kMost) json.push_back({{"after_s", silence.after}, {"seconds", silence.seconds}});
  }
  return json;
}

std::string utc(std::int64_t utime) {
  try {
    return fmt::format("{:%Y-%m-%d %H:%M:%S} UTC", fmt::gmtime(static_cast<std::time_t>(utime / 1'000'000)));
  } catch (const fmt::format_error&) {
    return fmt::format("{} us", utime);  // no calendar has that year
  }
}

}  // namespace

std::string info_text(const logs::LogSet& logs, const LogSummary& summary) {
  std::string text;
  for (const auto& file : logs.files()) {
    text += fmt::format("{}: {}, {} events{}\n", file->path(), size_text(static_cast<std::int64_t>(file->bytes())),
                        file->events().size(), file->damage().empty() ? "" : ", damaged");
  }
  text += fmt::format("{} to {}, {:.1f} s, {} events", utc(summary.first_utime), utc(summary.last_utime),
                      summary.seconds(), summary.events);
  text += "\n" + time_text(summary.steps);
  std::size_t wide = 7;
  std::size_t wide_type = 4;
  for (const ChannelSummary& channel : summary.channels) {
    wide = std::max(wide, channel.channel.size());
    wide_type = std::max(wide_type, type_text(channel).size());
  }
  text += fmt::format("\n{:<{}}  {:<{}}  {:>8}  {:>9}  {:>8}  {:>8}  {:>6}\n", "channel", wide, "type", wide_type,
                      "events", "size", "Hz", "gap s", "lost");
  for (const ChannelSummary& channel : summary.channels) {
    const std::string lost = channel.lost ? std::to_string(*channel.lost) : "-";
    std::string line =
        fmt::format("{:<{}}  {:<{}}  {:>8}  {:>9}  {:>8.2f}  {:>8.3f}  {:>6}  {}",
                    reflection::printable(channel.channel), wide, type_text(channel), wide_type, channel.events,
                    size_text(channel.bytes), channel.hz(), channel.longest_gap, lost, notes(channel));
    line.erase(line.find_last_not_of(' ') + 1);
    text += line + "\n";
  }
  return text + legend(summary);
}

nlohmann::ordered_json info_json(const logs::LogSet& logs, const LogSummary& summary) {
  nlohmann::ordered_json json;
  json["files"] = nlohmann::ordered_json::array();
  for (const auto& file : logs.files()) {
    auto damage = nlohmann::ordered_json::array();
    for (const logs::Damage& piece : file->damage())
      damage.push_back({{"offset", piece.offset}, {"bytes", piece.bytes}});
    json["files"].push_back({{"path", file->path()},
                             {"bytes", file->bytes()},
                             {"events", file->events().size()},
                             {"damage", std::move(damage)}});
  }
  json["first_utime"] = summary.first_utime;
  json["last_utime"] = summary.last_utime;
  json["seconds"] = summary.seconds();
  json["events"] = summary.events;
  json["non_monotonic"] = summary.steps.late;
  json["steps_back"] = summary.steps.back;
  json["farthest_back_s"] = summary.steps.farthest_back;
  json["disorder"] = summary.steps.farthest_back > kDisorder_s ? disorder_text(summary.steps) : "";
  json["silences"] = silences_json(summary.steps.silences);
  json["channels"] = nlohmann::ordered_json::array();
  for (const ChannelSummary& channel : summary.channels) {
    nlohmann::ordered_json entry;
    entry["channel"] = channel.channel;
    entry["type"] = channel.type.empty() ? nlohmann::ordered_json() : nlohmann::ordered_json(channel.type);
    entry["hash"] = reflection::fingerprint_text(channel.fingerprint);
    entry["events"] = channel.events;
    entry["bytes"] = channel.bytes;
    entry["largest_bytes"] = channel.largest;
    entry["too_large"] = channel.too_large;
    entry["hz"] = channel.hz();
    entry["first_utime"] = channel.first_utime;
    entry["last_utime"] = channel.last_utime;
    entry["longest_gap_s"] = channel.longest_gap;
    entry["sessions"] = channel.sessions;
    entry["lost"] = channel.lost ? nlohmann::ordered_json(*channel.lost) : nlohmann::ordered_json();
    entry["undecodable"] = channel.undecodable;
    entry["other_types"] = channel.other_types;
    entry["non_monotonic"] = channel.time_reversals;
    json["channels"].push_back(std::move(entry));
  }
  return json;
}

std::string damage_text(const logs::LogSet& logs, const LogSummary& summary) {
  std::string text;
  for (const auto& file : logs.files()) {
    for (const logs::Damage& piece : file->damage()) {
      text += fmt::format("{}: {} bytes from byte {} on belong to no event\n", file->path(), piece.bytes, piece.offset);
    }
  }
  for (const ChannelSummary& channel : summary.channels) {
    if (channel.undecodable == 0) continue;
    text += fmt::format("{}: {} of {} messages cannot be decoded\n", reflection::printable(channel.channel),
                        channel.undecodable, channel.events);
  }
  return text;
}

}  // namespace markservo::log_tool
