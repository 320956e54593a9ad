#pragma once

#include <stdexcept>
#include <string>

namespace markservo::recorder {

// Why there is no recording: what() is one line, or nothing where nothing is to be said; code() is what the program
// exits with.
class Refusal : public std::runtime_error {
 public:
  Refusal(int code, const std::string& why) : std::runtime_error(why), code_(code) {}
  int code() const { return code_; }

 private:
  int code_;
};

// An option that is none, or has a value that it may not have. Exit code 2.
class UsageError : public Refusal {
 public:
  explicit UsageError(const std::string& why) : Refusal(2, why) {}
};

}  // namespace markservo::recorder
