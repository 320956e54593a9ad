#pragma once

#include <map>
#include <string>
#include <vector>

namespace markservo::campaign {

struct ServiceProcess {
  int pid = 0;
  char state = '?';  // as in /proc/PID/stat
  double rss_mb = 0.0;
};

// The services' processes that belong to the stack of `runtime_dir`, by the service's name, from /proc. A service that
// is being started over may have two.
std::map<std::string, std::vector<ServiceProcess>> stack_processes(const std::string& runtime_dir,
                                                                   const std::vector<std::string>& services);

}  // namespace markservo::campaign
