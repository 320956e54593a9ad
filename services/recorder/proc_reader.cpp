#include "services/recorder/proc_reader.hpp"

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace markservo::recorder {
namespace {

namespace fs = std::filesystem;

std::string in_proc(pid_t process, const std::string& name) {
  return "/proc/" + std::to_string(process) + "/" + name;
}

// The first line of a file; nothing where it cannot be read.
std::optional<std::string> first_line(const std::string& path) {
  std::ifstream file(path);
  std::string line;
  if (!file) return std::nullopt;
  std::getline(file, line);
  return line;
}

std::vector<pid_t> numbered_entries(const std::string& folder) {
  std::vector<pid_t> numbers;
  std::error_code error;
  fs::directory_iterator entry(folder, error);
  for (const fs::directory_iterator end; !error && entry != end; entry.increment(error)) {
    const std::string name = entry->path().filename().string();
    pid_t number = 0;
    const auto [read, fault] = std::from_chars(name.data(), name.data() + name.size(), number);
    if (fault == std::errc() && read == name.data() + name.size()) numbers.push_back(number);
  }
  std::sort(numbers.begin(), numbers.end());
  return numbers;
}

// "PID (PROGRAM) STATE PARENT ...", where PROGRAM may hold anything.
pid_t parent_in(const std::string& status) {
  std::istringstream rest(status.substr(std::min(status.size(), status.rfind(')') + 1)));
  std::string state;
  pid_t parent = -1;
  rest >> state >> parent;
  return parent;
}

}  // namespace

std::optional<pid_t> child_named(pid_t parent, const std::string& name) {
  for (const pid_t process : numbered_entries("/proc")) {
    const auto status = first_line(in_proc(process, "stat"));
    if (status && parent_in(*status) == parent && program_of(process) == name) return process;
  }
  return std::nullopt;
}

std::string program_of(pid_t process) {
  return first_line(in_proc(process, "comm")).value_or("");
}

std::vector<pid_t> threads_of(pid_t process) {
  return numbered_entries(in_proc(process, "task"));
}

std::string waits_in(pid_t process, pid_t thread) {
  return first_line(in_proc(process, "task/" + std::to_string(thread) + "/wchan")).value_or("gone");
}

std::int64_t available_memory_kib() {
  std::ifstream file("/proc/meminfo");
  for (std::string line; std::getline(file, line);) {
    std::istringstream words(line);
    std::string name;
    std::int64_t kib = 0;
    if (words >> name >> kib && name == "MemAvailable:") return kib;
  }
  return 0;
}

std::optional<std::int64_t> largest_receive_buffer() {
  std::ifstream file("/proc/sys/net/core/rmem_max");
  std::int64_t bytes = 0;
  if (!(file >> bytes)) return std::nullopt;
  return bytes;
}

}  // namespace markservo::recorder
