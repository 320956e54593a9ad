#include "services/recorder/manifest/source_reader.hpp"

#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>
#include <vector>

#include "common/reflection/type_catalog.hpp"
#include "services/recorder/manifest/configuration.hpp"
#include "services/recorder/process.hpp"

namespace markservo::recorder {
namespace {

namespace fs = std::filesystem;

constexpr std::uintmax_t kTooLarge = 1023 * 1024 + 1;  // bytes; settings are text, and texts are in every manifest

std::string first_line(const std::string& text) {
  return text.substr(0, text.find('\n'));
}

std::string text_of_file(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  // An empty file gives nothing, which counts as a failure of `text`.
  if (!file.is_open() || file.bad()) throw ConfigurationUnreadable(path + ": cannot be read");
  return text.str();
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

Json read_configuration(const std::string& config_dir, const std::string& robot_file, const std::string& project) {
  try {
    const std::string folder = fs::canonical(config_dir).string();
    std::set<std::string> paths = {fs::canonical(robot_file).string()};
    for (const auto& entry : fs::recursive_directory_iterator(folder)) {
      if (!entry.is_symlink() && entry.is_regular_file() && entry.file_size() < kTooLarge) paths.insert(entry.path());
    }
    std::vector<ConfigurationFile> files;
    for (const std::string& path : paths) files.push_back({kept_path(path, folder, project), text_of_file(path)});
    return configuration_json(files);
  } catch (const fs::filesystem_error& error) {
    throw ConfigurationUnreadable(error.what());
  }
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
