#pragma once

// Strict reading of YAML: every key is asked for by name, checked against what is allowed, and none is left over.
// All errors are ConfigurationError with file, full key, value and what is allowed.

#include <yaml-cpp/yaml.h>

#include <Eigen/Core>
#include <set>
#include <string>
#include <vector>

namespace markservo::robot {

// What a number may be, with the words for the error.
struct Allowed {
  double min = 0.0;
  double max = 0.0;
  std::string words;

  static Allowed any();
  static Allowed positive();
  static Allowed between(double min, double max);
};

class YamlSection {
 public:
  // The whole file.
  static YamlSection load(const std::string& path);

  double number(const std::string& key, const Allowed& allowed);
  int integer(const std::string& key, int min, int max);
  std::string text(const std::string& key);
  std::string one_of(const std::string& key, const std::vector<std::string>& choices);
  Eigen::VectorXd numbers(const std::string& key, int size, const Allowed& allowed);
  std::vector<std::string> texts(const std::string& key);
  bool has(const std::string& key) const;

  YamlSection section(const std::string& key);
  std::vector<YamlSection> list(const std::string& key);

  // Throws if the file has a key that nobody asked for.
  void require_all_used() const;

  [[noreturn]] void fail(const std::string& key, const std::string& value, const std::string& allowed) const;

 private:
  // A name travels in messages and is shown to people.
  void require_harmless(const std::string& key, const std::string& value) const;
  YamlSection(std::string path, std::string prefix, const YAML::Node& node);
  YAML::Node required(const std::string& key);
  std::string full(const std::string& key) const;
  double to_number(const YAML::Node& node, const std::string& key, const Allowed& allowed) const;

  std::string path_;
  std::string prefix_;
  YAML::Node node_;
  std::set<std::string> used_;
};

}  // namespace markservo::robot
