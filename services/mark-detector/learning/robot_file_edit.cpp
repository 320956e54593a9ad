#include "services/mark-detector/learning/robot_file_edit.hpp"

#include <fmt/format.h>
#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

#include "common/robot/configuration_error.hpp"
#include "services/mark-detector/learning/file_replacement.hpp"

namespace markservo::mark_detector {
namespace {

struct Key {
  const char* name;
  double least;
  double greatest;
};

std::array<Key, 3> keys_of(const robot::ColourInterval& colour) {
  return {{{"hue_deg", colour.hue_min_deg, colour.hue_max_deg},
           {"saturation", colour.saturation_min, colour.saturation_max},
           {"value", colour.value_min, colour.value_max}}};
}

std::string number(double value) {
  std::string text = fmt::format("{:.10g}", value);
  if (text.find_first_of(".e") == std::string::npos) text += ".0";
  return text;
}

[[noreturn]] void fail(const std::string& path, const std::string& mark, const std::string& what) {
  throw ConfigurationError(path + ": marks: '" + mark + "': " + what);
}

YAML::Node parse(const std::string& text, const std::string& path) {
  try {
    return YAML::Load(text);
  } catch (const YAML::Exception& error) {
    throw ConfigurationError(path + ": not YAML: " + error.what());
  }
}

// The bytes of one number in the text, and what is to stand there.
struct Replacement {
  std::size_t begin = 0;
  std::size_t size = 0;
  std::string text;
};

// Where lines begin, for a place that YAML tells by line and column.
std::vector<std::size_t> line_starts(const std::string& text) {
  std::vector<std::size_t> starts{0};
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '\n') starts.push_back(i + 1);
  }
  return starts;
}

// Everything but one mark's colour, as YAML writes it: what an edit must not change.
std::vector<std::string> all_else(const YAML::Node& root, const std::string& mark) {
  std::vector<std::string> parts;
  for (const auto& section : root) {
    if (section.first.as<std::string>() != "marks") parts.push_back(YAML::Dump(section.second));
  }
  for (const YAML::Node& entry : root["marks"]) {
    const bool is_mark = entry["name"].as<std::string>() == mark;
    for (const auto& key : entry) {
      if (!is_mark || key.first.as<std::string>() != "colour") parts.push_back(YAML::Dump(key.second));
    }
  }
  return parts;
}

}  // namespace

std::string to_text(const robot::ColourInterval& colour) {
  std::string text;
  for (const Key& key : keys_of(colour)) {
    if (!text.empty()) text += ", ";
    text += std::string(key.name) + ": [" + number(key.least) + ", " + number(key.greatest) + "]";
  }
  return text;
}

std::string with_colour(const std::string& text, const std::string& path, const std::string& mark,
                        const robot::ColourInterval& colour) {
  const YAML::Node root = parse(text, path);
  YAML::Node found;
  try {
    for (const YAML::Node& entry : root["marks"]) {
      if (entry["name"].as<std::string>() == mark) found.reset(entry["colour"]);
    }
  } catch (const YAML::Exception&) {
    found.reset();
  }
  if (!found.IsMap()) fail(path, mark, "no such mark with a colour");

  const std::vector<std::size_t> lines = line_starts(text);
  std::vector<Replacement> replacements;
  for (const Key& key : keys_of(colour)) {
    const YAML::Node list = found[key.name];
    if (!list.IsSequence() || list.size() != 2) fail(path, mark, std::string("colour.") + key.name + " is no pair");
    for (std::size_t i = 0; i < 2; ++i) {
      const YAML::Mark place = list[i].Mark();
      const std::string old = list[i].as<std::string>();
      const auto line = static_cast<std::size_t>(place.line);
      const std::size_t begin = place.line < 0 || line >= lines.size()
                                    ? std::string::npos
                                    : lines[line] + static_cast<std::size_t>(place.column);
      if (begin == std::string::npos || text.compare(begin, old.size(), old) != 0) {
        fail(path, mark, std::string("colour.") + key.name + " cannot be edited; allowed: plain numbers");
      }
      replacements.push_back({begin, old.size(), number(i == 0 ? key.least : key.greatest)});
    }
  }
  std::string edited = text;
  // From behind, so that what is still to come stays in its place; keys may stand in any order.
  std::sort(replacements.begin(), replacements.end(),
            [](const Replacement& a, const Replacement& b) { return a.begin > b.begin; });
  for (const Replacement& r : replacements) edited.replace(r.begin, r.size, r.text);
  if (all_else(parse(edited, path), mark) != all_else(root, mark)) {
    fail(path, mark, "its colour is shared with another place (an alias); allowed: a colour of its own");
  }
  return edited;
}

void write_colour(const std::string& path, const std::string& mark, const robot::ColourInterval& colour) {
  replace_file(path, with_colour(read_file(path), path, mark, colour));
}

}  // namespace markservo::mark_detector
