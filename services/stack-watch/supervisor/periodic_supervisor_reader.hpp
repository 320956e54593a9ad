#pragma once

#include <atomic>
#include <functional>
#include <string>
#include <thread>

#include "services/stack-watch/supervisor/supervisor_memory.hpp"

namespace markservo::stack_watch {

// Asks supervisord once a second, so that nobody else waits for one that is slow.
class PeriodicSupervisorReader {
 public:
  using Handler = std::function<void(SupervisorAnswer)>;

  // `path`: its socket; `url`: the bus that its services should speak on. `handler` is called on a thread of its own.
  PeriodicSupervisorReader(std::string path, std::string url, Handler handler);
  ~PeriodicSupervisorReader();
  PeriodicSupervisorReader(const PeriodicSupervisorReader&) = delete;
  PeriodicSupervisorReader& operator=(const PeriodicSupervisorReader&) = delete;

 private:
  void ask_on();
  SupervisorAnswer ask() const;

  std::string path_;
  std::string url_;
  Handler handler_;
  std::atomic<bool> ended_{false};
  std::thread thread_;
};

}  // namespace markservo::stack_watch
