#include "services/recorder/folder/recording_folder.hpp"

#include <fcntl.h>
#include <spdlog/fmt/chrono.h>
#include <spdlog/fmt/fmt.h>
#include <sys/file.h>
#include <sys/statvfs.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "services/recorder/refusal.hpp"

namespace markservo::recorder {
namespace {

namespace fs = std::filesystem;

constexpr int kBadFolder = 2;
constexpr const char* kReserve = ".reserve";
constexpr std::size_t kReserveBytes = 262'144;

[[noreturn]] void cannot_be_made(const std::string& path, const std::string& why) {
  throw Refusal(kBadFolder, path + ": cannot be made: " + why);
}

}  // namespace

RecordingFolder RecordingFolder::made(const std::string& path) {
  std::error_code error;
  const bool empty = fs::is_directory(path, error) && fs::is_empty(path, error);
  if (!empty) {
    if (fs::exists(fs::symlink_status(path, error))) {
      throw Refusal(kBadFolder, path + ": exists already; allowed: a new name, or an empty folder");
    }
    fs::create_directories(path, error);
    if (error) cannot_be_made(path, error.message());
  }
  if (access(path.c_str(), W_OK) != 0) throw Refusal(kBadFolder, path + ": cannot be written");
  return {path, !empty};
}

std::optional<RecordingFolder> RecordingFolder::dated(const std::string& logs_dir, std::int64_t utime) {
  std::error_code error;
  fs::create_directories(logs_dir, error);
  if (error) cannot_be_made(logs_dir, error.message());
  const auto second = static_cast<std::time_t>(utime / 1'000'000);
  const std::string path = fmt::format("{}/{:%Y-%m-%d_%H-%M-%S}", logs_dir, fmt::localtime(second));
  if (!fs::create_directory(path, error)) {
    if (error) cannot_be_made(path, error.message());
    return std::nullopt;
  }
  return RecordingFolder(path, true);
}

RecordingFolder RecordingFolder::existing(const std::string& path) {
  return {path, false};
}

RecordingFolder::RecordingFolder(RecordingFolder&& other) noexcept
    : path_(std::move(other.path_)), made_(other.made_), lock_(std::exchange(other.lock_, -1)) {}

RecordingFolder::~RecordingFolder() {
  if (lock_ >= 0) close(lock_);
}

bool RecordingFolder::lock() {
  lock_ = open(path_.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  return lock_ >= 0 && flock(lock_, LOCK_EX | LOCK_NB) == 0;
}

std::vector<Part> RecordingFolder::parts() const {
  std::vector<Part> files;
  std::error_code error;
  fs::directory_iterator entry(path_, error);
  for (const fs::directory_iterator end; !error && entry != end; entry.increment(error)) {
    std::error_code gone;
    if (!entry->is_regular_file(gone)) continue;
    const auto bytes = entry->file_size(gone);
    if (!gone) files.push_back({entry->path().filename().string(), static_cast<std::int64_t>(bytes)});
  }
  return parts_in_order(std::move(files));
}

std::int64_t RecordingFolder::recorded_bytes() const {
  std::int64_t sum = 0;
  for (const Part& part : parts()) sum += part.bytes;
  return sum;
}

std::int64_t RecordingFolder::free_mb() const {
  constexpr std::uint64_t kMegabyte = 1'000'000;
  struct statvfs disk {};
  if (statvfs(path_.c_str(), &disk) != 0) return 0;
  return static_cast<std::int64_t>((std::uint64_t{disk.f_bavail} * disk.f_frsize + kMegabyte - 1) / kMegabyte);
}

void RecordingFolder::make_empty(const std::string& name) const {
  std::ofstream{file(name), std::ios::app};
}

void RecordingFolder::remove(const std::string& name) const {
  std::error_code ignored;
  fs::remove(file(name), ignored);
}

bool RecordingFolder::reserve() const {
  std::ofstream out(file(kReserve), std::ios::binary);
  out << std::string(kReserveBytes, '\0') << std::flush;
  return out.good();
}

void RecordingFolder::release_reserve() const {
  remove(kReserve);
}

void RecordingFolder::undo() const {
  release_reserve();
  for (const Part& part : parts()) remove(part.name);
  std::error_code ignored;
  if (made_) fs::remove(path_, ignored);
}

void point_latest_to(const std::string& logs_dir, const std::string& name) {
  std::error_code error;
  const std::string latest = logs_dir + "/latest";
  if (fs::is_symlink(latest, error)) fs::remove(latest, error);
  fs::create_symlink(name, latest, error);
}

}  // namespace markservo::recorder
