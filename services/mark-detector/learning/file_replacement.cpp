#include "services/mark-detector/learning/file_replacement.hpp"

#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "common/robot/configuration_error.hpp"

namespace markservo::mark_detector {
namespace {

[[noreturn]] void fail(const std::string& path, const char* what) {
  throw ConfigurationError(path + ": cannot be written: " + what + ": " + std::strerror(errno));
}

bool write_all(int file, const std::string& content) {
  std::size_t done = 0;
  while (done < content.size()) {
    const ssize_t written = ::write(file, content.data() + done, content.size() - done);
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) return false;
    done += static_cast<std::size_t>(written);
  }
  return true;
}

}  // namespace

std::string read_file(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::string content{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  if (!file) throw ConfigurationError(path + ": cannot be read");
  return content;
}

void replace_file(const std::string& path, const std::string& content) {
  std::error_code unresolved;
  const std::string target = std::filesystem::canonical(path, unresolved).string();
  struct stat status {};
  if (unresolved || ::stat(target.c_str(), &status) != 0) fail(path, "no such file");
  if (::access(target.c_str(), W_OK) != 0) fail(path, "not allowed");

  std::string temporary = target + ".XXXXXX";
  const int file = ::mkstemp(temporary.data());
  if (file < 0) fail(path, "its folder");
  const bool complete = write_all(file, content) && ::fchmod(file, status.st_mode & 07777U) == 0 && ::fsync(file) == 0;
  const bool closed = ::close(file) == 0;
  if (!complete || !closed || ::rename(temporary.c_str(), target.c_str()) != 0) {
    const int reason = errno;
    ::unlink(temporary.c_str());
    errno = reason;
    fail(path, "a new file beside it");
  }
}

}  // namespace markservo::mark_detector
