#include "tests/system/fault_campaign/stack_processes.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>

namespace markservo::campaign {
namespace {

std::string content(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

ServiceProcess describe(const std::filesystem::path& folder, int pid) {
  ServiceProcess process;
  process.pid = pid;
  const std::string stat = content(folder / "stat");
  const std::size_t name_end = stat.rfind(')');  // the name may hold anything
  if (name_end != std::string::npos && name_end + 2 < stat.size()) process.state = stat[name_end + 2];
  constexpr double kPage_mb = 4096.0 / 1e6;
  double total = 0.0;
  double resident = 0.0;
  std::istringstream(content(folder / "statm")) >> total >> resident;
  process.rss_mb = resident * kPage_mb;
  return process;
}

}  // namespace

std::map<std::string, std::vector<ServiceProcess>> stack_processes(const std::string& runtime_dir,
                                                                   const std::vector<std::string>& services) {
  std::map<std::string, std::vector<ServiceProcess>> found;
  const std::string mark = "MARKSERVO_STACK=" + runtime_dir;
  std::error_code error;
  for (const auto& entry : std::filesystem::directory_iterator("/proc", error)) {
    const std::string name = entry.path().filename().string();
    if (name.find_first_not_of("0123456789") != std::string::npos) continue;
    const auto executable = std::filesystem::read_symlink(entry.path() / "exe", error);
    if (error) continue;
    const std::string service = executable.filename().string();
    if (std::find(services.begin(), services.end(), service) == services.end()) continue;
    const std::string environment = content(entry.path() / "environ");
    if (environment.find(mark + '\0') == std::string::npos) continue;
    found[service].push_back(describe(entry.path(), std::stoi(name)));
  }
  return found;
}

}  // namespace markservo::campaign
