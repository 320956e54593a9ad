#pragma once

#include <string>
#include <string_view>

namespace markservo::text {

// What a person types, for the words that name it: `scripts/log` in a checkout, `markservo log` where it is installed.
// A script that runs a program for him starts it under the name that he typed (exec -a).
class TypedCommand {
 public:
  TypedCommand() = default;
  // `program`: the command line's first word; none of a script's: it was started by its path.
  explicit TypedCommand(std::string_view program);

  // "log" of `scripts/log`, or `own`, the program's name, where that was started by its path: before what it says.
  std::string name_or(const std::string& own) const { return name_.empty() ? own : name_; }
  // "scripts/log", or `own` likewise: what to type again.
  std::string call_or(const std::string& own) const { return name_.empty() ? own : of(name_); }
  // What to type for the command `name`.
  std::string of(const std::string& name) const { return before_ + name; }

 private:
  std::string before_ = "scripts/";
  std::string name_;
};

}  // namespace markservo::text
