#pragma once

#include <unistd.h>

#include <string>

namespace markservo::bus {

// This host's, as SERVICE_STATUS carries it.
inline std::string host_name() {
  char name[256] = {};
  gethostname(name, sizeof name - 1);
  return name;
}

}  // namespace markservo::bus
