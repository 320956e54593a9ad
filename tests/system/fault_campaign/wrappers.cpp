// The services' executables as the trial's stack runs them: behind scripts that can limit descriptors and set clocks.

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <stdexcept>

#include "tests/system/fault_campaign/fault.hpp"

namespace markservo::campaign {
namespace {

namespace fs = std::filesystem;

fs::path control_file(const Bench& bench, const std::string& what, const std::string& service) {
  return fs::path(bench.folders().out) / "wrapped" / (what + "-" + service);
}

void write_file(const fs::path& path, const std::string& text) {
  // Readers see the old or the new one.
  const fs::path fresh = path.string() + ".new";
  std::ofstream(fresh) << text;
  fs::rename(fresh, path);
}

std::string wrapper(const Bench& bench, const std::string& service, bool settable_clocks) {
  const std::string limit = control_file(bench, "nofile", service);
  std::string text = "#!/bin/bash\nif [[ -f '" + limit + "' ]]; then ulimit -n \"$(<'" + limit + "')\"; fi\n";
  if (settable_clocks) {
    // The steady clock stays: only what the hour is told by is set.
    text +=
        "export LD_PRELOAD=libfaketime.so.1 LD_LIBRARY_PATH=/usr/lib/$(uname -m)-linux-gnu/faketime\n"
        "export FAKETIME_TIMESTAMP_FILE='" +
        control_file(bench, "clock", service).string() +
        "' FAKETIME_CACHE_DURATION=1 FAKETIME_DONT_FAKE_MONOTONIC=1 DONT_FAKE_MONOTONIC=1 NO_FAKE_STAT=1\n";
  }
  return text + "exec '" + bench.folders().build + "/bin/" + service + "' \"$@\"\n";
}

}  // namespace

void set_clock(const Bench& bench, const std::string& service, const std::string& faketime) {
  write_file(control_file(bench, "clock", service), faketime + "\n");
}

void limit_descriptors(const Bench& bench, const std::string& service, int most) {
  write_file(control_file(bench, "nofile", service), std::to_string(most) + "\n");
}

void unlimit_descriptors(const Bench& bench, const std::string& service) {
  fs::remove(control_file(bench, "nofile", service));
}

std::string wrap_services(const Bench& bench, bool settable_clocks) {
  const fs::path folder = fs::path(bench.folders().out) / "wrapped";
  fs::create_directories(folder / "bin");
  for (const auto& entry : fs::directory_iterator(fs::path(bench.folders().build) / "bin")) {
    const std::string name = entry.path().filename();
    const auto& services = Bench::services();
    if (std::find(services.begin(), services.end(), name) == services.end()) {
      fs::create_symlink(entry.path(), folder / "bin" / name);
      continue;
    }
    if (settable_clocks) set_clock(bench, name, "+0");
    std::ofstream(folder / "bin" / name) << wrapper(bench, name, settable_clocks);
    fs::permissions(folder / "bin" / name, fs::perms::owner_all);
  }
  return folder.string();
}

}  // namespace markservo::campaign
