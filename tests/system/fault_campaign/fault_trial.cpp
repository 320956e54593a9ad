// fault-trial: one trial of the fault campaign, on the private network that it is started on (scripts/private-network).

#include <CLI/CLI.hpp>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>

#include "tests/system/fault_campaign/trial.hpp"

namespace {

using namespace markservo::campaign;

int run(const Plan& plan, BenchFolders folders) {
  std::string runtime = "/tmp/markservo-fault-XXXXXX";
  if (mkdtemp(runtime.data()) == nullptr) throw std::runtime_error(runtime + ": cannot be made");
  folders.runtime = runtime;
  const nlohmann::json report = Trial(plan, folders).run();
  std::filesystem::remove_all(runtime);
  std::ofstream(folders.out + "/trial.json")
      << report.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) << "\n";
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("One trial of the fault campaign");
  std::int64_t seed = 1;
  int draw = 0;
  std::string kind;
  std::string phase;
  BenchFolders folders;
  app.add_option("--seed", seed)->required();
  app.add_option("--draw", draw);
  app.add_option("--kind", kind, "This fault alone, as second-writer:JOINT_STATE");
  app.add_option("--phase", phase, "In this phase; with --kind");
  app.add_option("--repository", folders.repository)->required();
  app.add_option("--build-dir", folders.build, "Has bin/SERVICE")->required();
  app.add_option("--out", folders.out)->required();
  CLI11_PARSE(app, argc, argv);
  if (std::getenv("MARKSERVO_PRIVATE_NETWORK") == nullptr) {
    std::cerr << "fault-trial: this is no private network: start it by scripts/private-network\n";
    return 2;
  }
  try {
    return run(kind.empty() ? plan_of(seed, draw) : plan_with(seed, kind, phase), folders);
  } catch (const std::exception& error) {
    std::cerr << "fault-trial: " << error.what() << "\n";
    return 1;
  }
}
