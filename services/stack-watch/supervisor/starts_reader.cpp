#include "services/stack-watch/supervisor/starts_reader.hpp"

#include <fstream>

namespace markservo::stack_watch {

void note_starts(const std::string& path, SupervisedProcess& process) {
  std::ifstream starts(path.substr(0, path.rfind('/') + 1) + "starts/" + process.name);
  std::ifstream uptime("/proc/uptime");
  int crashes = 0;
  double start_cs = 0.0;  // hundredths of a second since boot
  double up_s = 0.0;
  if (!(starts >> crashes >> start_cs) || !(uptime >> up_s)) return;
  process.crashes = crashes;
  process.next_start_s = 0.01 * start_cs - up_s;
}

}  // namespace markservo::stack_watch
