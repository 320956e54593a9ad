#pragma once

#include <memory>
#include <string>

struct re_pattern_buffer;

namespace markservo::log_tool {

// A person's expression for whole channel names: an extended regular expression (POSIX).
class NameExpression {
 public:
  // Throws std::invalid_argument for a text that is none.
  explicit NameExpression(const std::string& text);

  // False for a name with a zero byte in it, which no bus carries.
  bool matches(const std::string& name) const;

 private:
  std::shared_ptr<re_pattern_buffer> compiled_;
};

}  // namespace markservo::log_tool
