#pragma once

#include <yaml-cpp/yaml.h>

#include <string>

namespace markservo::robot {

// Of one key written twice yaml-cpp gives the first and says nothing; the second is where the change was made. Throws
// ConfigurationError with `path`, key and both lines where a map in `root` has a key twice, and where `root` is nested
// more deeply or holds more values than a file that a person wrote.
void refuse_repeated_keys(const std::string& path, const YAML::Node& root);

}  // namespace markservo::robot
