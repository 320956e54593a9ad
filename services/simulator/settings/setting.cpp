#include "services/simulator/settings/setting.hpp"

#include <fmt/format.h>

#include "common/robot/configuration_error.hpp"

namespace markservo::simulator {

std::string setting_text(double value) {
  return fmt::format("{:.10g}", value);
}

void refuse_setting(const std::string& name, const std::string& value, const std::string& allowed) {
  throw ConfigurationError("setting '" + name + "' is " + value + "; allowed: " + allowed);
}

}  // namespace markservo::simulator
