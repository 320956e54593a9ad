#include "services/bus-top/channel_table.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>

#include "common/reflection/type_catalog.hpp"
#include "common/reflection/value_text.hpp"

namespace markservo::bus_top {
namespace {

struct Row {
  std::string channel;
  std::string type;
  std::string figures;
};

constexpr const char* kFigures = "{:>7} {:>9} {:>8} {:>6} {:>11} {:>7} {}";

std::string type_text(const watch::ChannelFigures& figures) {
  if (!figures.type.empty()) return figures.type;
  if (!figures.fingerprint) return fmt::format("? ({})", size_text(static_cast<double>(figures.newest_bytes)));
  return fmt::format("{} ({})", reflection::fingerprint_text(*figures.fingerprint),
                     size_text(static_cast<double>(figures.newest_bytes)));
}

std::string count_or_dash(std::int64_t count, bool known) {
  return known ? std::to_string(count) : "-";
}

std::string figures_text(const watch::ChannelFigures& figures) {
  return fmt::format(kFigures, figures.hz ? fmt::format("{:.1f}", *figures.hz) : "-",
                     figures.bytes_per_second ? size_text(*figures.bytes_per_second) + "/s" : "-",
                     fmt::format("{:.1f} s", figures.age),
                     count_or_dash(figures.lost.value_or(0), figures.lost.has_value()), figures.undecodable,
                     count_or_dash(figures.writers, figures.sessions > 0), figures.stale ? "stale" : "");
}

}  // namespace

std::string size_text(double bytes) {
  constexpr std::array<const char*, 5> kUnits{"B", "kB", "MB", "GB", "TB"};
  std::size_t unit = 0;
  while (bytes >= 999.5 && unit + 1 < kUnits.size()) {
    bytes /= 1000.0;
    ++unit;
  }
  if (unit == 0) return fmt::format("{:.0f} B", bytes);
  return fmt::format("{:.{}f} {}", bytes, bytes < 9.995 ? 2 : (bytes < 99.95 ? 1 : 0), kUnits[unit]);
}

ChannelTable channel_table(const watch::BusWatch& watch, double now) {
  ChannelTable table;
  std::vector<Row> rows{
      {"channel", "type", fmt::format(kFigures, "Hz", "bandwidth", "age", "lost", "undecodable", "writers", "")}};
  for (const auto& [channel, entry] : watch.channels()) {
    const watch::ChannelFigures figures = entry.watch.figures(now);
    table.lines.push_back({channel, {}, figures.stale, figures.undecodable > 0 || figures.lost.value_or(0) > 0});
    rows.push_back({reflection::printable(channel), type_text(figures), figures_text(figures)});
  }
  std::size_t channel_width = 0;
  std::size_t type_width = 0;
  for (const Row& row : rows) {
    channel_width = std::max(channel_width, row.channel.size());
    type_width = std::max(type_width, row.type.size());
  }
  for (std::size_t i = 0; i < rows.size(); ++i) {
    std::string& text = i == 0 ? table.heading : table.lines[i - 1].text;
    text = fmt::format("{:<{}}  {:<{}} {}", rows[i].channel, channel_width, rows[i].type, type_width, rows[i].figures);
    text.erase(text.find_last_not_of(' ') + 1);
  }
  return table;
}

}  // namespace markservo::bus_top
