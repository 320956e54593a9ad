#include "common/text/typed_command.hpp"

namespace markservo::text {

TypedCommand::TypedCommand(std::string_view program) {
  constexpr std::string_view kOfNames = "abcdefghijklmnopqrstuvwxyz-";
  for (const std::string_view before : {"scripts/", "markservo "}) {
    if (program.substr(0, before.size()) != before) continue;
    const std::string_view name = program.substr(before.size());
    if (name.empty() || name.find_first_not_of(kOfNames) != std::string_view::npos) continue;
    before_ = before;
    name_ = name;
  }
}

}  // namespace markservo::text
