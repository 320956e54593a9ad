#pragma once

#include <stdexcept>
#include <string>

namespace markservo::bus {

// What a log that is written in place of a bus should hold does not fit there: ends a service with exit code 1.
class LogNotWritten : public std::runtime_error {
 public:
  LogNotWritten(const std::string& path, const std::string& why)
      : std::runtime_error("log " + path + " cannot be written: " + why + "; allowed: a file on a disk with room") {}
};

}  // namespace markservo::bus
