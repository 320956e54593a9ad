#include "tests/replay/replay_run.hpp"

#include <stdlib.h>

#include <filesystem>
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

}  // namespace markservo::replay
