#include "services/mark-detector/mark_option.hpp"

#include <cstdlib>
#include <sstream>
#include <vector>

#include "common/robot/configuration_error.hpp"

namespace markservo::mark_detector {
namespace {

[[noreturn]] void fail(const std::string& text, const std::string& what) {
  throw ConfigurationError(
      "--mark '" + text + "': " + what +
      "; allowed: NAME=hue_min:hue_max:sat_min:sat_max:val_min:val_max[:plane|:free|:ball], hue 0 to "
      "360 degrees, saturation and value 0 to 1, rising");
}

double number(const std::string& text, const std::string& word, double max) {
  char* end = nullptr;
  const double value = std::strtod(word.c_str(), &end);
  if (word.empty() || *end != '\0' || !(value >= 0.0 && value <= max)) fail(text, "'" + word + "' cannot be used");
  return value;
}

}  // namespace

robot::MarkDescription parse_mark(const std::string& text) {
  constexpr std::size_t kNumbers = 6;
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos || equals == 0) fail(text, "no name");
  robot::MarkDescription mark;
  mark.name = text.substr(0, equals);
  if (mark.name.find('/') != std::string::npos) fail(text, "'/' in the name, which also names files");
  std::vector<std::string> words;
  std::istringstream rest(text.substr(equals + 1));
  for (std::string word; std::getline(rest, word, ':');) words.push_back(word);
  if (words.size() == kNumbers + 1 && words.back() == "free") {
    mark.surface = robot::MarkSurface::kFree;
  } else if (words.size() == kNumbers + 1 && words.back() == "ball") {
    mark.surface = robot::MarkSurface::kBall;
  } else if (words.size() == kNumbers + 1 && words.back() != "plane") {
    fail(text, "surface '" + words.back() + "'");
  }
  if (words.size() != kNumbers && words.size() != kNumbers + 1) {
    fail(text, std::to_string(words.size()) + " fields after the name");
  }
  constexpr double kFullTurn_deg = 360.0;
  mark.colour.hue_min_deg = number(text, words[0], kFullTurn_deg);
  mark.colour.hue_max_deg = number(text, words[1], kFullTurn_deg);
  mark.colour.saturation_min = number(text, words[2], 1.0);
  mark.colour.saturation_max = number(text, words[3], 1.0);
  mark.colour.value_min = number(text, words[4], 1.0);
  mark.colour.value_max = number(text, words[5], 1.0);
  if (mark.colour.saturation_min > mark.colour.saturation_max) fail(text, "saturation falls");
  if (mark.colour.value_min > mark.colour.value_max) fail(text, "value falls");
  return mark;
}

}  // namespace markservo::mark_detector
