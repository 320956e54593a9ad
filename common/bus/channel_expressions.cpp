#include "common/bus/channel_expressions.hpp"

#include <markservo/channels.hpp>

#include "common/bus/robot_channel.hpp"

namespace markservo::bus {

std::string expression_of(const std::string& channel) {
  std::string expression;
  for (const char character : channel) {
    if (std::string("\\^$.|?*+()[]{}").find(character) != std::string::npos) expression += '\\';
    expression += character;
  }
  return expression;
}

AllChannels all_channels(const std::string& robot) {
  const std::string prefix = expression_of(robot_channel(robot, ""));
  std::string names;
  for (const channels::Entry& channel : channels::kAll) {
    if (channel.large) names += (names.empty() ? "" : "|") + expression_of(channel.name);
  }
  const std::string large = "(.*/)?(" + names + ")";
  return {prefix + large, prefix + "(?!" + large + "$).*"};
}

}  // namespace markservo::bus
