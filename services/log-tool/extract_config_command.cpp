#include "services/log-tool/extract_config_command.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "common/logs/log_files.hpp"

namespace markservo::log_tool {
namespace {

namespace fs = std::filesystem;

// Where the manifest's `path` goes; a recording from elsewhere must not write where it likes.
fs::path target(const fs::path& folder, const std::string& path, const std::string& manifest) {
  const fs::path relative = fs::path(path).lexically_normal();
  const bool leaves = std::any_of(relative.begin(), relative.end(), [](const fs::path& part) { return part == ".."; });
  if (path.empty() || relative.is_absolute() || leaves) {
    throw logs::LogFileError(manifest + ": configuration path '" + path + "'; allowed: one within the project");
  }
  return folder / relative;
}

}  // namespace

std::string extract_config(const std::string& recording, const std::string& folder) {
  const std::string path = recording + "/manifest.json";
  std::ifstream file(path);
  if (!file) {
    throw logs::LogFileError(path +
                             ": cannot be read; allowed: the folder of a recording, which keeps the configuration "
                             "(a log alone does not)");
  }
  std::string report;
  try {
    const auto manifest = nlohmann::json::parse(file);
    for (const auto& entry : manifest.at("configuration").at("files")) {
      const fs::path place = target(folder, entry.at("path").get<std::string>(), path);
      const std::string text = entry.at("text").get<std::string>();
      if (fs::exists(place)) throw logs::LogFileError(place.string() + ": exists; allowed: a new folder");
      fs::create_directories(place.parent_path());
      std::ofstream out(place, std::ios::binary);
      out << text;
      out.flush();
      if (!out) throw logs::LogFileError(place.string() + ": cannot be written; allowed: a folder that can be written");
      report += place.string() + "\n";
    }
  } catch (const nlohmann::json::exception& error) {
    throw logs::LogFileError(path + ": no manifest of a recording: " + error.what());
  } catch (const fs::filesystem_error& error) {
    throw logs::LogFileError(folder + ": " + error.code().message() + "; allowed: a folder that can be written");
  }
  return report;
}

}  // namespace markservo::log_tool
