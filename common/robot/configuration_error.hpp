#pragma once

#include <stdexcept>
#include <string>

namespace markservo {

// A setting that cannot be used. what() is one line: file, key, value, what is allowed. Ends a service with exit
// code 2.
class ConfigurationError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace markservo
