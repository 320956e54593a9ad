#include "services/stack-watch/supervisor/command_line.hpp"

#include <algorithm>
#include <fstream>

namespace markservo::stack_watch {

std::vector<std::string> command_line_of(int pid) {
  std::ifstream file("/proc/" + std::to_string(pid) + "/cmdline", std::ios::binary);
  std::vector<std::string> arguments;
  for (std::string argument; std::getline(file, argument, '\0');) arguments.push_back(argument);
  return arguments;
}

bool must_speak(const std::vector<std::string>& command_line, const std::string& name, const std::string& url) {
  if (command_line.empty()) return false;
  const std::string& program = command_line.front();
  if (program.substr(program.rfind('/') + 1) != name) return false;
  for (std::size_t i = 1; i < command_line.size(); ++i) {
    for (const std::string option : {"--lcm-url", "--lcm-out"}) {
      const std::string& argument = command_line[i];
      if (argument == option && i + 1 < command_line.size() && command_line[i + 1] != url) return false;
      if (argument.rfind(option + "=", 0) == 0 && argument.substr(option.size() + 1) != url) return false;
    }
  }
  return true;
}

}  // namespace markservo::stack_watch
