#include "common/robot/yaml_section.hpp"

#include <cmath>
#include <limits>
#include <sstream>
#include <utility>

#include "common/robot/configuration_error.hpp"
#include "common/robot/repeated_keys.hpp"
#include "common/text/text.hpp"

namespace markservo::robot {
namespace {

std::string number_text(double value) {
  std::ostringstream text;
  text << value;
  return text.str();
}

std::string node_text(const YAML::Node& node) {
  if (node.IsScalar()) return node.Scalar();
  if (node.IsSequence()) return "a list of " + std::to_string(node.size());
  if (node.IsMap()) return "a section";
  return "nothing";
}

}  // namespace

Allowed Allowed::any() {
  const double inf = std::numeric_limits<double>::infinity();
  return {-inf, inf, "a finite number"};
}

Allowed Allowed::positive() {
  return {std::numeric_limits<double>::min(), std::numeric_limits<double>::infinity(), "a number above 0"};
}

Allowed Allowed::between(double min, double max) {
  return {min, max, "a number from " + number_text(min) + " to " + number_text(max)};
}

YamlSection::YamlSection(std::string path, std::string prefix, const YAML::Node& node)
    : path_(std::move(path)), prefix_(std::move(prefix)), node_(node) {}

YamlSection YamlSection::load(const std::string& path) {
  std::vector<YAML::Node> documents;
  try {
    documents = YAML::LoadAllFromFile(path);
  } catch (const YAML::BadFile&) {
    throw ConfigurationError(path + ": cannot be opened; allowed: a readable YAML file");
  } catch (const YAML::Exception& error) {
    throw ConfigurationError(path + ": line " + std::to_string(error.mark.line + 1) + ": " + error.msg +
                             "; allowed: well-formed YAML");
  }
  if (documents.size() > 1) {
    throw ConfigurationError(path + ": holds " + std::to_string(documents.size()) +
                             " YAML documents; allowed: one, without a line '---' in it");
  }
  const YAML::Node root = documents.empty() ? YAML::Node() : documents.front();
  if (!root.IsMap()) throw ConfigurationError(path + ": is " + node_text(root) + "; allowed: sections with keys");
  refuse_repeated_keys(path, root);
  return {path, "", root};
}

std::string YamlSection::full(const std::string& key) const {
  return prefix_.empty() ? key : prefix_ + "." + key;
}

void YamlSection::fail(const std::string& key, const std::string& value, const std::string& allowed) const {
  throw ConfigurationError(path_ + ": key '" + full(key) + "' is " + value + "; allowed: " + allowed);
}

bool YamlSection::has(const std::string& key) const {
  return node_[key].IsDefined();
}

YAML::Node YamlSection::required(const std::string& key) {
  used_.insert(key);
  const YAML::Node child = node_[key];
  if (!child.IsDefined()) {
    throw ConfigurationError(path_ + ": key '" + full(key) + "' is missing; allowed: every key is required");
  }
  return child;
}

double YamlSection::to_number(const YAML::Node& node, const std::string& key, const Allowed& allowed) const {
  double value = 0.0;
  try {
    value = node.as<double>();
  } catch (const YAML::Exception&) {
    fail(key, "'" + node_text(node) + "'", allowed.words);
  }
  if (!std::isfinite(value) || value < allowed.min || value > allowed.max) fail(key, node_text(node), allowed.words);
  return value;
}

double YamlSection::number(const std::string& key, const Allowed& allowed) {
  return to_number(required(key), key, allowed);
}

int YamlSection::integer(const std::string& key, int min, int max) {
  const YAML::Node node = required(key);
  const std::string allowed = "a whole number from " + std::to_string(min) + " to " + std::to_string(max);
  int value = 0;
  if (!node.IsScalar() || !text::is_decimal(node.Scalar())) fail(key, "'" + node_text(node) + "'", allowed);
  try {
    value = node.as<int>();
  } catch (const YAML::Exception&) {
    fail(key, "'" + node_text(node) + "'", allowed);
  }
  if (value < min || value > max) fail(key, node_text(node), allowed);
  return value;
}

void YamlSection::require_harmless(const std::string& key, const std::string& value) const {
  if (text::violation(key, value).empty()) return;
  fail(key, "'" + text::printable(value) + "'",
       "a text of at most " + std::to_string(text::kMaxBytes) +
           " bytes of UTF-8, without control characters and marks of direction");
}

std::string YamlSection::text(const std::string& key) {
  const YAML::Node node = required(key);
  if (!node.IsScalar() || node.Scalar().empty()) fail(key, node_text(node), "a text");
  require_harmless(key, node.Scalar());
  return node.Scalar();
}

std::string YamlSection::one_of(const std::string& key, const std::vector<std::string>& choices) {
  std::string value = text(key);
  std::string words;
  for (const auto& choice : choices) {
    if (value == choice) return value;
    words += (words.empty() ? "" : " or ") + choice;
  }
  fail(key, "'" + value + "'", words);
}

Eigen::VectorXd YamlSection::numbers(const std::string& key, int size, const Allowed& allowed) {
  const YAML::Node node = required(key);
  const std::string words = std::to_string(size) + " numbers, each " + allowed.words;
  if (!node.IsSequence() || node.size() != static_cast<std::size_t>(size)) fail(key, node_text(node), words);
  Eigen::VectorXd values(size);
  for (int i = 0; i < size; ++i) values[i] = to_number(node[i], key + "[" + std::to_string(i) + "]", allowed);
  return values;
}

std::vector<std::string> YamlSection::texts(const std::string& key) {
  const YAML::Node node = required(key);
  if (!node.IsSequence()) fail(key, node_text(node), "a list of texts");
  std::vector<std::string> values;
  for (const auto& item : node) {
    if (!item.IsScalar() || item.Scalar().empty()) fail(key, "a list with " + node_text(item), "a list of texts");
    require_harmless(key, item.Scalar());
    values.push_back(item.Scalar());
  }
  return values;
}

YamlSection YamlSection::section(const std::string& key) {
  const YAML::Node node = required(key);
  if (!node.IsMap()) fail(key, node_text(node), "a section with keys");
  return {path_, full(key), node};
}

std::vector<YamlSection> YamlSection::list(const std::string& key) {
  const YAML::Node node = required(key);
  if (!node.IsSequence()) fail(key, node_text(node), "a list of sections");
  std::vector<YamlSection> sections;
  for (std::size_t i = 0; i < node.size(); ++i) {
    const std::string item = full(key) + "[" + std::to_string(i) + "]";
    if (!node[i].IsMap()) {
      throw ConfigurationError(path_ + ": key '" + item + "' is " + node_text(node[i]) +
                               "; allowed: a section with keys");
    }
    sections.push_back(YamlSection(path_, item, node[i]));
  }
  return sections;
}

void YamlSection::require_all_used() const {
  for (const auto& pair : node_) {
    const std::string key = pair.first.Scalar();
    if (used_.count(key) > 0) continue;
    std::string known;
    for (const auto& name : used_) known += (known.empty() ? "" : ", ") + name;
    throw ConfigurationError(path_ + ": key '" + full(key) + "' is unknown; allowed: " + known);
  }
}

}  // namespace markservo::robot
