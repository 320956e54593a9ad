#include "services/recorder/manifest/manifest_file.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cstdio>
#include <fstream>

namespace markservo::recorder {
namespace {

std::string unfinished_path(const std::string& folder) {
  return manifest_path(folder) + ".new";
}

bool write_to_disk(const std::string& path, const std::string& text) {
  const int file = open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  if (file < 0) return false;
  bool good = true;
  for (std::size_t done = 0; good && done < text.size();) {
    const ssize_t written = write(file, text.data() + done, text.size() - done);
    good = written > 0;
    if (good) done += static_cast<std::size_t>(written);
  }
  good = good && fdatasync(file) == 0;
  return close(file) == 0 && good;
}

}  // namespace

bool write_manifest(const std::string& folder, const Json& manifest) {
  const std::string unfinished = unfinished_path(folder);
  return write_to_disk(unfinished, manifest_text(manifest)) &&
         std::rename(unfinished.c_str(), manifest_path(folder).c_str()) == 0;
}

Json read_manifest(const std::string& folder) {
  std::ifstream file(manifest_path(folder));
  if (!file) return {};
  Json json = Json::parse(file, nullptr, false);
  return json.is_discarded() ? Json() : json;
}

std::string manifest_path(const std::string& folder) {
  return folder + "/manifest.json";
}

void remove_unfinished_manifest(const std::string& folder) {
  std::remove(unfinished_path(folder).c_str());
}

void remove_manifest(const std::string& folder) {
  remove_unfinished_manifest(folder);
  std::remove(manifest_path(folder).c_str());
}

}  // namespace markservo::recorder
