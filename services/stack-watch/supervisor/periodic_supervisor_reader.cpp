#include "services/stack-watch/supervisor/periodic_supervisor_reader.hpp"

#include <chrono>
#include <utility>

#include "services/stack-watch/supervisor/command_line.hpp"
#include "services/stack-watch/supervisor/starts_reader.hpp"
#include "services/stack-watch/supervisor/supervisor_reader.hpp"

namespace markservo::stack_watch {

PeriodicSupervisorReader::PeriodicSupervisorReader(std::string path, std::string url, Handler handler)
    : path_(std::move(path)), url_(std::move(url)), handler_(std::move(handler)) {
  thread_ = std::thread([this] { ask_on(); });
}

PeriodicSupervisorReader::~PeriodicSupervisorReader() {
  ended_ = true;
  thread_.join();
}

void PeriodicSupervisorReader::ask_on() {
  while (!ended_) {
    handler_(ask());
    // In parts, so that the end is noticed soon.
    for (int i = 0; i < 10 && !ended_; ++i) std::this_thread::sleep_for(std::chrono::milliseconds(100));
  }
}

SupervisorAnswer PeriodicSupervisorReader::ask() const {
  SupervisorAnswer answer;
  try {
    answer.processes = ask_supervisor(path_);
    answer.alive = true;
    for (SupervisedProcess& process : answer.processes) {
      note_starts(path_, process);
      if (!runs(process)) continue;
      const bool speaks = must_speak(command_line_of(process.pid), process.name, url_);
      answer.running.push_back({process.name, process.pid, speaks});
    }
  } catch (const SupervisorSilent& error) {
    answer.why_not = error.what();
  } catch (const CannotAsk& error) {
    answer.cannot_ask = error.what();
  }
  return answer;
}

}  // namespace markservo::stack_watch
