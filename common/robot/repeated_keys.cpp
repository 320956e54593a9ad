#include "common/robot/repeated_keys.hpp"

#include <cstddef>
#include <map>
#include <utility>

#include "common/robot/configuration_error.hpp"
#include "common/text/text.hpp"

namespace markservo::robot {
namespace {

class RepeatedKeys {
 public:
  explicit RepeatedKeys(std::string path) : path_(std::move(path)) {}

  // Throws ConfigurationError for a key twice in `node` or below it.
  void refuse(const std::string& prefix, const YAML::Node& node, int depth = 0) {
    if (depth > kDeepest) {
      throw ConfigurationError(path_ + ": is nested more than " + std::to_string(kDeepest) +
                               " levels deep, or within itself; allowed: fewer");
    }
    if (++seen_ > kMostValues) {
      throw ConfigurationError(path_ + ": holds more than " + std::to_string(kMostValues) + " values; allowed: fewer");
    }
    if (node.IsSequence()) {
      std::size_t number = 0;
      for (const auto& item : node) refuse(prefix + "[" + std::to_string(number++) + "]", item, depth + 1);
    }
    if (node.IsMap()) refuse_in_map(prefix, node, depth);
  }

 private:
  // An alias of an alias of an alias is a short file and a long walk.
  static constexpr int kMostValues = 1'000'000;
  static constexpr int kDeepest = 64;  // an alias may stand within what it stands for

  void refuse_in_map(const std::string& prefix, const YAML::Node& map, int depth) {
    std::map<std::string, int> lines;
    for (const auto& pair : map) {
      if (!pair.first.IsScalar()) continue;  // no key of ours: refused where it stands
      const std::string key = (prefix.empty() ? "" : prefix + ".") + pair.first.Scalar();
      const int line = pair.first.Mark().line + 1;
      const auto [first, fresh] = lines.emplace(key, line);
      if (!fresh) {
        throw ConfigurationError(path_ + ": key '" + text::printable(key) + "' stands twice, on lines " +
                                 std::to_string(first->second) + " and " + std::to_string(line) + "; allowed: once");
      }
      refuse(key, pair.second, depth + 1);
    }
  }

  std::string path_;
  int seen_ = 0;
};

}  // namespace

void refuse_repeated_keys(const std::string& path, const YAML::Node& root) {
  RepeatedKeys(path).refuse("", root);
}

}  // namespace markservo::robot
