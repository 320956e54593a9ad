#include "common/bus/log_output.hpp"

#include <cerrno>
#include <cstdio>
#include <cstring>

#include "common/bus/bus_unavailable.hpp"

namespace markservo::bus {

LogOutput::LogOutput(const std::string& path) : file_(path, "w") {
  if (file_.good()) return;
  throw BusUnavailable("log " + path + " cannot be written: " + std::strerror(errno) +
                       "; allowed: a file in a folder that can be written");
}

bool LogOutput::write(const Outgoing& message) {
  lcm::LogEvent event{};
  event.timestamp = message.utime;
  event.channel = message.channel;
  event.datalen = static_cast<int>(message.size);
  event.data = const_cast<void*>(message.data);  // only read
  return file_.writeEvent(&event) == 0;
}

bool LogOutput::flush() {
  return std::fflush(file_.getFilePtr()) == 0;
}

}  // namespace markservo::bus
