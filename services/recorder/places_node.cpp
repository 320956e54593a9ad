#include "services/recorder/places_node.hpp"

#include <utility>

#include "common/time/clocks.hpp"
#include "services/recorder/plain_path.hpp"

namespace markservo::recorder {

RecordingFolder new_folder_of(const RecorderOptions& options, SignalQueue& signals) {
  if (!options.out.empty()) return RecordingFolder::made(plain_path(options.out));
  if (!options.name.empty()) return RecordingFolder::made(options.places.logs_dir + "/" + options.name);
  return new_dated_folder(options.places.logs_dir, signals);
}

RecordingFolder new_dated_folder(const std::string& logs_dir, SignalQueue& signals) {
  constexpr std::int64_t kPause_us = 200'000;
  while (true) {
    auto folder = RecordingFolder::dated(logs_dir, wall_clock_us());
    if (folder) return std::move(*folder);
    signals.wait(kPause_us);
  }
}

std::string shown(const std::string& folder, const RecorderOptions& options) {
  const std::string project = options.places.project + "/";
  return folder.rfind(project, 0) == 0 ? folder.substr(project.size()) : folder;
}

}  // namespace markservo::recorder
