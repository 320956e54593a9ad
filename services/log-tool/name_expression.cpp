#include "services/log-tool/name_expression.hpp"

#include <regex.h>

#include <array>
#include <stdexcept>

namespace markservo::log_tool {

NameExpression::NameExpression(const std::string& text) {
  auto compiled = std::make_unique<regex_t>();
  const int error = regcomp(compiled.get(), ("^(" + text + ")$").c_str(), REG_EXTENDED | REG_NOSUB);
  if (error != 0) {
    std::array<char, 200> why{};
    regerror(error, compiled.get(), why.data(), why.size());
    throw std::invalid_argument("channel expression '" + text + "': " + why.data() +
                                "; allowed: an extended regular expression (POSIX)");
  }
  compiled_ = {compiled.release(), [](regex_t* regex) {
                 regfree(regex);
                 delete regex;
               }};
}

bool NameExpression::matches(const std::string& name) const {
  return name.find('\0') == std::string::npos && regexec(compiled_.get(), name.c_str(), 0, nullptr, 0) == 0;
}

}  // namespace markservo::log_tool
