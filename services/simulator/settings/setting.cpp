#include "services/simulator/settings/setting.hpp"

#include <cstdio>

#include "common/robot/configuration_error.hpp"

namespace markservo::simulator {

std::string setting_text(double value) {
  char buffer[32];
  std::snprintf(buffer, sizeof buffer, "%.10g", value);
  return buffer;
}

void refuse_setting(const std::string& name, const std::string& value, const std::string& allowed) {
  throw ConfigurationError("setting '" + name + "' is " + value + "; allowed: " + allowed);
}

}  // namespace markservo::simulator
