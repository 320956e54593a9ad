#include "tests/replay/replay_run.hpp"

#include <stdlib.h>

#include <filesystem>
#include <lcm/lcm-cpp.hpp>
#include <stdexcept>

#include "tests/experiments/child_process.hpp"

namespace markservo::replay {

TemporaryFolder::TemporaryFolder() {
  std::string name = (std::filesystem::temp_directory_path() / "markservo-replay-XXXXXX").string();
  if (mkdtemp(name.data()) == nullptr) throw std::runtime_error(name + ": cannot be made");
  path_ = name;
}

TemporaryFolder::~TemporaryFolder() {
  std::filesystem::remove_all(path_);
}

int run_service_alone(const TemporaryFolder& folder, const std::string& name,
                      const std::vector<std::string>& arguments) {
  std::vector<std::string> command{std::string(MARKSERVO_BIN_DIR "/") + name};
  command.insert(command.end(), arguments.begin(), arguments.end());
  return experiments::ChildProcess(command, folder.path(name + ".log")).wait();
}

int run_through(const TemporaryFolder& folder, const std::string& name, const std::string& in, const std::string& out,
                std::vector<std::string> arguments) {
  arguments.insert(arguments.end(), {"--lcm-in", "file://" + folder.path(in) + "?speed=0", "--lcm-out",
                                     "file://" + folder.path(out) + "?mode=w"});
  return run_service_alone(folder, name, arguments);
}

std::vector<std::pair<std::string, std::string>> events_of(const std::string& log_path) {
  std::vector<std::pair<std::string, std::string>> events;
  lcm::LogFile log(log_path, "r");
  while (const auto* event = log.good() ? log.readNextEvent() : nullptr) {
    events.emplace_back(event->channel,
                        std::string(static_cast<const char*>(event->data), static_cast<std::size_t>(event->datalen)));
  }
  return events;
}

}  // namespace markservo::replay
