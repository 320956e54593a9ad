#include "common/census/census_text.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "common/reflection/type_catalog.hpp"
#include "common/reflection/value_text.hpp"

namespace markservo::census {
namespace {

using Json = nlohmann::ordered_json;

// As text: JSON's numbers hold 53 bits.
std::string hex(std::int64_t number) {
  return reflection::fingerprint_text(static_cast<std::uint64_t>(number));
}

Json text_or_null(const std::string& text) {
  return text.empty() ? Json() : Json(text);
}

Json json_of(const ChannelWord& word) {
  return {{"channel", word.channel},
          {"received", word.received},
          {"skipped", word.skipped},
          {"lost", word.lost},
          {"decode_failures", word.decode_failures},
          {"refused", word.refused},
          {"second_writer", word.second_writer},
          {"age_s", word.age},
          {"latency_p50_s", word.latency_p50},
          {"latency_p99_s", word.latency_p99}};
}

Json json_of(const ServiceReport& service) {
  Json json = json_of(service.newest);
  json["version"] = service.newest.version;
  json["config_hash"] = hex(service.newest.config_hash);
  json["heard"] = service.heard;
  json["silent_s"] = service.silent_s;
  json["clock_behind_s"] = service.clock_behind_s;
  json["duplicate"] = service.duplicate;
  json["writes"] = service.writes;
  json["channels"] = Json::array();
  for (const ChannelWord& word : service.newest.channels) json["channels"].push_back(json_of(word));
  return json;
}

Json json_of(const ChannelReport& channel) {
  Json json = {{"channel", channel.channel},
               {"type", text_or_null(channel.type)},
               {"hash", hex(channel.hash)},
               {"events", channel.events},
               {"hz", channel.hz},
               {"bytes_per_s", channel.bytes_per_s},
               {"lost", channel.lost},
               {"several_types", channel.several_types},
               {"two_writers", channel.two_writers},
               {"writers", Json::array()},
               {"other_versions", Json::array()}};
  for (const WriterReport& writer : channel.writers) {
    json["writers"].push_back(
        {{"session", hex(writer.session)}, {"service", text_or_null(writer.service)}, {"events", writer.events}});
  }
  for (const OtherWriterReport& writer : channel.other_versions) {
    json["other_versions"].push_back({{"type", writer.type},
                                      {"our_hash", hex(writer.our_hash)},
                                      {"hash", hex(writer.hash)},
                                      {"session", hex(writer.session)},
                                      {"service", text_or_null(writer.service)},
                                      {"events", writer.events}});
  }
  return json;
}

using Row = std::vector<std::string>;

// Columns as wide as their widest cell; the first and the last to the left, the others to the right.
std::string aligned(const std::vector<Row>& rows) {
  std::vector<std::size_t> widths(rows.front().size(), 0);
  for (const Row& row : rows) {
    for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], row[i].size());
  }
  std::string text;
  for (const Row& row : rows) {
    for (std::size_t i = 0; i + 1 < row.size(); ++i) {
      const std::string padding(widths[i] - row[i].size(), ' ');
      text += (i == 0 ? row[i] + padding : padding + row[i]) + "  ";
    }
    text += row.back();
    text.erase(text.find_last_not_of(' ') + 1);
    text += '\n';
  }
  return text;
}

std::string number(double value) {
  return fmt::format("{:.1f}", value);
}

std::string remarks_of(const ServiceReport& service) {
  std::string text = service.newest.state;
  if (!service.newest.reason.empty()) text += ": " + service.newest.reason;
  if (service.duplicate) text += "; SEVERAL PROCESSES OF THIS NAME";
  for (const ChannelWord& word : service.newest.channels) {
    if (word.second_writer) text += "; a second writer on " + word.channel;
  }
  return reflection::printable(text);
}

Row row_of(const ServiceReport& service) {
  std::int64_t skipped = 0;
  std::int64_t lost = 0;
  std::int64_t refused = 0;
  double latency = 0.0;
  for (const ChannelWord& word : service.newest.channels) {
    skipped += word.skipped;
    lost += word.lost;
    refused += word.refused + word.decode_failures;
    latency = std::max(latency, word.latency_p99);
  }
  const ServiceWord& word = service.newest;
  return {reflection::printable((word.robot.empty() ? "" : word.robot + "/") + word.name),
          reflection::printable(word.host),
          std::to_string(word.pid),
          reflection::printable(word.version),
          std::to_string(skipped),
          std::to_string(lost),
          std::to_string(refused),
          number(1e3 * latency),
          remarks_of(service)};
}

Row row_of(const ChannelReport& channel) {
  std::string writers;
  for (const WriterReport& writer : channel.writers) {
    writers += (writers.empty() ? "" : ", ") + (writer.service.empty() ? hex(writer.session) : writer.service);
  }
  if (channel.two_writers) writers += "; TWO WRITE AT THE SAME TIME";
  if (channel.several_types) writers += "; SEVERAL TYPES";
  for (const OtherWriterReport& writer : channel.other_versions) {
    writers += "; " + (writer.service.empty() ? hex(writer.session) : writer.service) + " WRITES ANOTHER VERSION OF " +
               writer.type + ": " + hex(writer.hash) + ", here " + hex(writer.our_hash);
  }
  return {reflection::printable(channel.channel),
          channel.type.empty() ? "unknown " + hex(channel.hash) : channel.type,
          number(channel.hz),
          number(1e-3 * channel.bytes_per_s),
          std::to_string(channel.lost),
          reflection::printable(writers)};
}

}  // namespace

Json json_of(const ServiceWord& word) {
  return {
      {"robot", word.robot},          {"name", word.name},   {"host", word.host},     {"pid", word.pid},
      {"session", hex(word.session)}, {"state", word.state}, {"reason", word.reason}, {"ready", is_ready(word.state)}};
}

Json json_of(const Report& report) {
  Json json = {{"listened_s", report.listened_s}, {"services", Json::array()}, {"channels", Json::array()}};
  for (const ServiceReport& service : report.services) json["services"].push_back(json_of(service));
  for (const ChannelReport& channel : report.channels) json["channels"].push_back(json_of(channel));
  return json;
}

std::string table_of(const Report& report) {
  std::vector<Row> services{{"service", "host", "pid", "version", "skipped", "lost", "refused", "p99 ms", "says"}};
  for (const ServiceReport& service : report.services) services.push_back(row_of(service));
  std::vector<Row> channels{{"channel", "type", "Hz", "kB/s", "lost", "written by"}};
  for (const ChannelReport& channel : report.channels) channels.push_back(row_of(channel));
  std::string text = "heard in " + number(report.listened_s) + " s:\n";
  if (report.services.empty() && report.channels.empty()) return text + "nobody\n";
  return text + aligned(services) + "\n" + aligned(channels);
}

std::optional<std::int64_t> session_of(const std::string& text) {
  constexpr std::size_t kMostDigits = 16;
  const std::string digits = text.substr(0, 2) == "0x" ? text.substr(2) : "";
  if (digits.empty() || digits.size() > kMostDigits) return std::nullopt;
  if (digits.find_first_not_of("0123456789abcdefABCDEF") != std::string::npos) return std::nullopt;
  return static_cast<std::int64_t>(std::stoull(digits, nullptr, 16));
}

}  // namespace markservo::census
