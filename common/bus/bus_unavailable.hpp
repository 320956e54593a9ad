#pragma once

#include <stdexcept>

namespace markservo::bus {

// The bus cannot be joined. Ends a service with exit code 3.
class BusUnavailable : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace markservo::bus
