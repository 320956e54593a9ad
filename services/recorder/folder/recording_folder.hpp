#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "services/recorder/folder/part_names.hpp"

namespace markservo::recorder {

// A recording's folder: its parts, and who may write there.
class RecordingFolder {
 public:
  // Makes `path`, or takes it where it is an empty folder. Throws Refusal.
  static RecordingFolder made(const std::string& path);
  // Makes logs_dir/TIME, `utime` (us since the epoch) as the local clock shows it; nothing where somebody else has
  // taken that second. Throws Refusal.
  static std::optional<RecordingFolder> dated(const std::string& logs_dir, std::int64_t utime);
  // A folder that is there already.
  static RecordingFolder existing(const std::string& path);

  RecordingFolder(RecordingFolder&& other) noexcept;
  ~RecordingFolder();
  RecordingFolder(const RecordingFolder&) = delete;
  RecordingFolder& operator=(const RecordingFolder&) = delete;

  const std::string& path() const { return path_; }
  std::string name() const { return path_.substr(path_.rfind('/') + 1); }
  std::string file(const std::string& name) const { return path_ + "/" + name; }

  // Takes the folder for this recording; false while another one goes into it. Whoever writes there holds the lock, and
  // it ends with him.
  bool lock();
  int lock_descriptor() const { return lock_; }

  std::vector<Part> parts() const;
  std::int64_t recorded_bytes() const;
  // What an ordinary user can still write on its disk, MB; 0 where that is not known.
  std::int64_t free_mb() const;

  void make_empty(const std::string& name) const;
  void remove(const std::string& name) const;

  // What the end of the manifest needs when the disk is full. False where there is no room for it.
  bool reserve() const;
  void release_reserve() const;

  // Nothing was recorded: neither its parts nor, where it was made for them, the folder are left behind. What else was
  // written there is to be gone before.
  void undo() const;

 private:
  RecordingFolder(std::string path, bool made) : path_(std::move(path)), made_(made) {}

  std::string path_;
  bool made_;
  int lock_ = -1;
};

// logs_dir/latest, for a folder in it.
void point_latest_to(const std::string& logs_dir, const std::string& name);

}  // namespace markservo::recorder
