#include "common/logs/log_files.hpp"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>

#include "common/logs/log_format.hpp"
#include "common/reflection/message_value.hpp"

namespace markservo::logs {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void complain(const std::string& path, const std::string& what, const std::string& allowed) {
  throw LogFileError(path + ": " + what + "; allowed: " + allowed);
}

constexpr const char* kALog = "an LCM log, as lcm-logger writes it";

// "log.lcm", or "log.lcm." and digits.
bool is_part(const std::string& name) {
  static const std::string kName = "log.lcm";
  if (name.rfind(kName, 0) != 0) return false;
  const std::string rest = name.substr(kName.size());
  return rest.empty() ||
         (rest.size() > 1 && rest[0] == '.' && rest.find_first_not_of("0123456789", 1) == std::string::npos);
}

std::vector<std::string> parts_of(const std::string& folder) {
  std::vector<std::string> parts;
  for (const auto& entry : fs::directory_iterator(folder)) {
    if (is_part(entry.path().filename().string())) parts.push_back(entry.path().string());
  }
  // log.lcm.99 comes before log.lcm.100.
  std::sort(parts.begin(), parts.end(), [](const std::string& a, const std::string& b) {
    return a.size() != b.size() ? a.size() < b.size() : a < b;
  });
  if (parts.empty()) complain(folder, "holds no log.lcm", "a recording's folder, or an LCM log");
  return parts;
}

}  // namespace

LogFile::LogFile(const std::string& path, const FitCheck& fit) : path_(path) {
  const int file = open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);  // a pipe nobody writes to must not hold us
  if (file < 0) complain(path, std::strerror(errno), kALog);
  struct stat status {};
  if (fstat(file, &status) != 0 || !S_ISREG(status.st_mode)) {
    close(file);
    complain(path, "is no regular file", kALog);
  }
  size_ = static_cast<std::size_t>(status.st_size);
  if (size_ > 0) {
    map_ = mmap(nullptr, size_, PROT_READ, MAP_PRIVATE, file, 0);
  }
  close(file);
  if (size_ == 0) complain(path, "is empty", kALog);
  if (map_ == MAP_FAILED) complain(path, std::strerror(errno), kALog);
  scan_ = scan({static_cast<const std::uint8_t*>(map_), size_}, fit);
  if (scan_.events.empty()) {
    munmap(map_, size_);
    complain(path, "no event is found in its " + std::to_string(size_) + " bytes", kALog);
  }
}

LogFile::~LogFile() {
  munmap(map_, size_);
}

LogSet::LogSet(const std::vector<std::string>& paths, const FitCheck& fit) {
  for (const std::string& path : paths) {
    std::error_code ignored;
    if (!fs::is_directory(path, ignored)) {
      files_.push_back(std::make_unique<LogFile>(path, fit));
      continue;
    }
    try {
      std::vector<std::string> parts = parts_of(path);
      const auto first_empty =
          std::stable_partition(parts.begin(), parts.end(), [](const auto& part) { return fs::file_size(part) > 0; });
      // All empty: the first then says so.
      parts.erase(std::max(first_empty, parts.begin() + 1), parts.end());
      for (const std::string& part : parts) files_.push_back(std::make_unique<LogFile>(part, fit));
    } catch (const fs::filesystem_error& error) {
      complain(path, error.code().message(), "a recording's folder that can be read");
    }
  }
}

std::vector<LogEvent> LogSet::events() const {
  std::vector<LogEvent> all;
  for (const auto& file : files_) all.insert(all.end(), file->events().begin(), file->events().end());
  return all;
}

bool LogSet::damaged() const {
  return std::any_of(files_.begin(), files_.end(), [](const auto& file) { return !file->damage().empty(); });
}

FitCheck fit_of(const reflection::TypeCatalog& types) {
  return [&types](ByteView message) {
    std::uint64_t fingerprint = 0;
    if (!reflection::read_fingerprint(message.data, message.size, &fingerprint)) return Fit::kUnknownType;
    if (types.find(fingerprint) == nullptr) return Fit::kUnknownType;
    return reflection::decode(types, message.data, message.size).error.empty() ? Fit::kFits : Fit::kDoesNot;
  };
}

void write_log(const std::string& path, const std::vector<LogEvent>& events) {
  // "x": a log that is there is never overwritten.
  std::FILE* file = std::fopen(path.c_str(), "wbx");
  if (file == nullptr) complain(path, std::strerror(errno), "a new file in a folder that can be written");
  bool good = true;
  for (const LogEvent& event : events) {
    const std::string bytes = encoded(event);
    good = good && std::fwrite(bytes.data(), 1, bytes.size(), file) == bytes.size();
  }
  int error = errno;
  if (std::fclose(file) != 0) {
    error = errno;
    good = false;
  }
  if (good) return;
  std::remove(path.c_str());
  complain(path, std::string("cannot be written: ") + std::strerror(error), "a disk with room for the log");
}

}  // namespace markservo::logs
