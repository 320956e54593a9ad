#include "services/recorder/finish_node.hpp"

#include <sys/stat.h>
#include <unistd.h>

#include "services/recorder/folder/recording_folder.hpp"
#include "services/recorder/manifest/manifest_file.hpp"
#include "services/recorder/manifest/manifest_words.hpp"
#include "services/recorder/manifest/source_reader.hpp"
#include "services/recorder/places_node.hpp"
#include "services/recorder/plain_path.hpp"
#include "services/recorder/recording_end.hpp"
#include "services/recorder/refusal.hpp"
#include "services/recorder/terminal.hpp"

namespace markservo::recorder {
namespace {

constexpr int kBadFolder = 2;
constexpr int kFaulty = 1;

// When the file was last written, us since the epoch.
std::int64_t written_utime(const std::string& path) {
  struct stat status {};
  if (stat(path.c_str(), &status) != 0) return 0;
  return status.st_mtim.tv_sec * std::int64_t{1'000'000} + status.st_mtim.tv_nsec / 1000;
}

}  // namespace

void finish_recording(const RecorderOptions& options) {
  RecordingFolder folder = RecordingFolder::existing(plain_path(options.finish));
  const auto told = [&options, &folder](const Json& manifest) {
    return shown(folder.path(), options) + ": " + told_of_recording(manifest, options.commands.log);
  };
  Json manifest = read_manifest(folder.path());
  if (!is_manifest(manifest) && access(manifest_path(folder.path()).c_str(), F_OK) == 0) {
    throw Refusal(kBadFolder,
                  "--finish " + folder.path() + ": its manifest.json is empty or torn; allowed: a folder that " +
                      options.commands.record +
                      " made. Its log, if it has one, can be read without: " + options.commands.log + " info");
  }
  if (!is_manifest(manifest)) {
    throw Refusal(kBadFolder, "--finish " + folder.path() +
                                  ": has no manifest.json of a recording; allowed: a folder that " +
                                  options.commands.record + " made");
  }
  if (!folder.lock()) {
    throw Refusal(kBadFolder, "--finish " + folder.path() + ": is still being recorded; end that first");
  }
  // Whoever held the lock until now may have completed it.
  manifest = read_manifest(folder.path());
  if (is_complete(manifest)) {
    say("complete already: " + told(manifest));
    return;
  }
  folder.release_reserve();
  remove_unfinished_manifest(folder.path());
  const std::vector<Part> parts = folder.parts();
  const std::string newest = parts.empty() ? manifest_path(folder.path()) : folder.file(parts.back().name);
  const ManifestEnd end{
      text_of(EndReason::kKilled), written_utime(newest), std::nullopt, "", parts, 0, found_in(folder)};
  complete(&manifest, end);
  if (!write_manifest(folder.path(), manifest)) {
    throw Refusal(kFaulty, manifest_path(folder.path()) + ": cannot be written");
  }
  say("completed " + told(manifest));
}

}  // namespace markservo::recorder
