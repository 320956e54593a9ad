#include "services/log-tool/comparison_report.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "common/reflection/value_text.hpp"

namespace markservo::log_tool {
namespace {

using reflection::printable;

std::string largest_text(const ChannelComparison& channel) {
  if (channel.largest == 0.0) return "";
  if (std::isinf(channel.largest)) return channel.largest_field;
  return fmt::format("{:.3g} in {}", channel.largest, channel.largest_field);
}

}  // namespace

std::string comparison_text(const LogComparison& comparison, const ComparisonParameters& parameters) {
  std::size_t wide = 7;
  for (const auto& [name, channel] : comparison.channels) wide = std::max(wide, name.size());
  std::string text = fmt::format("{:<{}}  {:>7}  {:>7}  {:>9}  {:>7}  {:>7}  {:>7}  {}\n", "channel", wide, "equal",
                                 "within", "different", "missing", "extra", "outside", "largest difference");
  for (const auto& [name, channel] : comparison.channels) {
    std::string line = fmt::format("{:<{}}  {:>7}  {:>7}  {:>9}  {:>7}  {:>7}  {:>7}  {}", printable(name), wide,
                                   channel.equal, channel.within, channel.different, channel.missing, channel.extra,
                                   channel.outside, largest_text(channel));
    line.erase(line.find_last_not_of(' ') + 1);
    text += line + "\n";
  }
  text += fmt::format("tolerance {:g}, absolute and relative\n", parameters.tolerance);
  if (comparison.first) {
    const FieldDifference& first = *comparison.first;
    text += fmt::format("first difference: {} utime {} {}: recorded {}, replayed {}\n", first.channel, first.utime,
                        first.field.empty() ? "message" : first.field, printable(first.recorded),
                        printable(first.replayed));
  }
  return text;
}

std::string first_mismatch(const std::vector<logs::LogEvent>& one, const std::vector<logs::LogEvent>& other) {
  for (std::size_t i = 0; i < std::min(one.size(), other.size()); ++i) {
    if (one[i].channel != other[i].channel) {
      return fmt::format("event {}: channel {} here, {} there", i, printable(std::string(one[i].channel)),
                         printable(std::string(other[i].channel)));
    }
    if (one[i].data.text() != other[i].data.text()) {
      return fmt::format("event {}: {} differs in its payload", i, printable(std::string(one[i].channel)));
    }
  }
  if (one.size() != other.size()) return fmt::format("{} events here, {} there", one.size(), other.size());
  return {};
}

}  // namespace markservo::log_tool
