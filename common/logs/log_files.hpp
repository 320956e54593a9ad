#pragma once

#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "common/logs/log_scan.hpp"
#include "common/reflection/type_catalog.hpp"

namespace markservo::logs {

// A file that cannot be read as a log or written as one. One line: file, what, what is allowed. Exit code 2.
class LogFileError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// A log file in memory, read only, for as long as this lives.
class LogFile {
 public:
  // Throws LogFileError when it cannot be read, is empty, or holds no event at all.
  LogFile(const std::string& path, const FitCheck& fit);
  ~LogFile();
  LogFile(const LogFile&) = delete;
  LogFile& operator=(const LogFile&) = delete;

  const std::string& path() const { return path_; }
  std::size_t bytes() const { return size_; }
  const std::vector<LogEvent>& events() const { return scan_.events; }
  const std::vector<Damage>& damage() const { return scan_.damage; }

 private:
  std::string path_;
  void* map_ = nullptr;
  std::size_t size_ = 0;
  Scan scan_;
};

// One log, or all the parts of one in their order.
class LogSet {
 public:
  // Each path a log, or a recording's folder: its parts log.lcm, log.lcm.00, log.lcm.01, ... A part that holds nothing
  // (the recorder was killed as it began it) is left out when there are others. Throws LogFileError.
  LogSet(const std::vector<std::string>& paths, const FitCheck& fit);

  const std::vector<std::unique_ptr<LogFile>>& files() const { return files_; }
  std::vector<LogEvent> events() const;
  bool damaged() const;

 private:
  std::vector<std::unique_ptr<LogFile>> files_;
};

// Decides by the types of `types`, which must live as long as what comes back.
FitCheck fit_of(const reflection::TypeCatalog& types);

// Writes the events as a log that did not exist before. Throws LogFileError, and then leaves none behind.
void write_log(const std::string& path, const std::vector<LogEvent>& events);

}  // namespace markservo::logs
