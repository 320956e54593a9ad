#include "common/bus/config_file.hpp"

#include <algorithm>
#include <istream>
#include <map>
#include <string>

namespace markservo::bus {
namespace {

// Up to a '#' outside of quotes that begins the line or comes after a space, without spaces around.
std::string without_comment(const std::string& line) {
  bool quoted = false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (line[i] == '"') quoted = !quoted;
    if (!quoted && line[i] == '#' && (i == 0 || line[i - 1] == ' ' || line[i - 1] == '\t')) {
      return CLI::detail::trim_copy(line.substr(0, i));
    }
  }
  return CLI::detail::trim_copy(line);
}

std::vector<std::string> values_of(const std::string& text) {
  std::vector<std::string> values = {text};
  if (text.size() > 1 && text.front() == '[' && text.back() == ']') {
    values = CLI::detail::split_up(text.substr(1, text.size() - 2), ',');
  }
  for (std::string& value : values) CLI::detail::remove_quotes(CLI::detail::trim(value));
  return values;
}

}  // namespace

std::vector<CLI::ConfigItem> ConfigFile::from_config(std::istream& input) const {
  std::vector<CLI::ConfigItem> settings;
  std::map<std::string, int> lines;
  int number = 0;
  const std::string file = app_->get_config_ptr() != nullptr ? app_->get_config_ptr()->as<std::string>() : "";
  const auto fail = [&](const std::string& what) {
    throw CLI::ConfigError(file + ": line " + std::to_string(number) + ": " + what);
  };
  for (std::string line; std::getline(input, line);) {
    ++number;
    line = without_comment(line);
    if (line.empty()) continue;
    const std::size_t equals = line.find('=');
    const std::string value = equals == std::string::npos ? "true" : CLI::detail::trim_copy(line.substr(equals + 1));
    CLI::ConfigItem item;
    item.name = CLI::detail::trim_copy(line.substr(0, equals));
    item.inputs = values_of(value);
    const CLI::Option* option = app_->get_option_no_throw("--" + item.name);
    if (option == nullptr || !option->get_configurable()) {
      fail("key '" + item.name + "' is unknown; allowed: the options that --help lists, without their dashes");
    }
    const auto [first, fresh] = lines.emplace(item.name, number);
    if (!fresh && option->get_items_expected_max() <= 1) {
      fail("key '" + item.name + "' stands twice, first on line " + std::to_string(first->second) + "; allowed: once");
    }
    if (value.empty()) fail("key '" + item.name + "' has no value; allowed: one, or no such line");
    if (value == "\"\"") continue;  // as --print-config writes what is not set
    const auto earlier =
        std::find_if(settings.begin(), settings.end(), [&item](const auto& one) { return one.name == item.name; });
    if (earlier != settings.end()) {
      earlier->inputs.insert(earlier->inputs.end(), item.inputs.begin(), item.inputs.end());
    } else {
      settings.push_back(item);
    }
  }
  return settings;
}

}  // namespace markservo::bus
