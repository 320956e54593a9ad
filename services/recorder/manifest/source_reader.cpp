#include "services/recorder/manifest/source_reader.hpp"

#include <array>
#include <filesystem>
#include <fstream>
#include <optional>
#include <set>
#include <vector>

#include "common/reflection/type_catalog.hpp"
#include "services/recorder/manifest/configuration.hpp"
#include "services/recorder/plain_path.hpp"
#include "services/recorder/process.hpp"

namespace markservo::recorder {
namespace {

namespace fs = std::filesystem;

constexpr std::uintmax_t kTooLarge = 1023 * 1024 + 1;  // bytes; settings are text, and texts are in every manifest

std::string first_line(const std::string& text) {
  return text.substr(0, text.find('\n'));
}

// Nothing where it cannot be read.
std::optional<std::string> text_of_file(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::string text;
  std::array<char, 4096> piece{};
  while (file.read(piece.data(), piece.size()) || file.gcount() > 0) {
    text.append(piece.data(), static_cast<std::size_t>(file.gcount()));
  }
  if (!file.is_open() || file.bad()) return std::nullopt;
  return text;
}

bool is_kept(const fs::directory_entry& entry) {
  std::error_code error;
  if (entry.is_symlink(error) || !entry.is_regular_file(error)) return false;
  const std::uintmax_t size = entry.file_size(error);
  return error || size < kTooLarge;  // one that cannot be asked cannot be read either, which is told
}

// Adds the files in `folder`, and in the folders below it, that are kept; to `unreadable` the folders that cannot be
// read.
void gather(const std::string& folder, std::set<std::string>* files, std::vector<std::string>* unreadable) {
  std::error_code error;
  fs::directory_iterator entry(folder, error);
  for (; !error && entry != fs::directory_iterator(); entry.increment(error)) {
    std::error_code none;
    if (is_kept(*entry)) {
      files->insert(entry->path());
    } else if (!entry->is_symlink(none) && entry->is_directory(none)) {
      gather(entry->path(), files, unreadable);
    }
  }
  if (error) unreadable->push_back(folder);
}

std::string canonical_or_plain(const std::string& path) {
  std::error_code error;
  const std::string canonical = fs::canonical(path, error).string();
  return error ? plain_path(path) : canonical;
}

// The file of that name beside this program.
std::string sibling(const std::string& name) {
  std::error_code error;
  return (fs::read_symlink("/proc/self/exe", error).parent_path() / name).string();
}

}  // namespace

Json source_version(const std::string& project) {
  const CommandOutput commit = output_of({"git", "-C", project, "rev-parse", "HEAD"});
  if (commit.exit_code != 0) return {};
  const CommandOutput changes = output_of({"git", "-C", project, "status", "--porcelain"});
  return {{"commit", first_line(commit.text)}, {"dirty", !changes.text.empty()}};
}

Json message_types() {
  Json types;
  for (const auto* type : reflection::TypeCatalog::ours().all()) {
    types[type->name] = reflection::fingerprint_text(type->fingerprint);
  }
  return types;
}

std::string lcm_version() {
  return output_of({"dpkg-query", "-W", "-f", "${Version}", "liblcm-bin"}).text;
}

ReadConfiguration read_configuration(const std::string& config_dir, const std::string& robot_file,
                                     const std::string& project) {
  const ConfigurationSources sources{canonical_or_plain(config_dir), canonical_or_plain(robot_file), project};
  ReadConfiguration read;
  std::set<std::string> found = {sources.robot_file};
  gather(sources.config_dir, &found, &read.unreadable);
  const std::vector<std::string> paths(found.begin(), found.end());
  const std::vector<std::string> kept = kept_paths(paths, sources);
  std::vector<ConfigurationFile> files;
  std::string robot_kept;
  for (std::size_t i = 0; i < paths.size(); ++i) {
    files.push_back({kept[i], text_of_file(paths[i])});
    if (!files.back().text) read.unreadable.push_back(paths[i]);
    if (paths[i] == sources.robot_file) robot_kept = kept[i];
  }
  read.kept = configuration_json(files, robot_kept);
  return read;
}

Json found_in(const RecordingFolder& folder) {
  if (folder.recorded_bytes() == 0) return nothing_found();
  // A long recording takes minutes, which Ctrl-C ends: it is for log-tool then, whatever it does here.
  const CommandOutput report = output_of({sibling("log-tool"), "info", "--json", folder.path()});
  if (report.exit_code != 0 && report.exit_code != 1) return {};  // 1: it is damaged, and said where
  Json found = Json::parse(report.text, nullptr, false);
  return found.is_object() ? found : Json();
}

}  // namespace markservo::recorder
