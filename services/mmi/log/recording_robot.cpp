#include "services/mmi/log/recording_robot.hpp"

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "common/robot/configuration_error.hpp"

namespace markservo::mmi {
namespace {

namespace fs = std::filesystem;

// A file of its own for as long as it lives.
class PassingFile {
 public:
  explicit PassingFile(const std::string& text) {
    std::string folder = (fs::temp_directory_path() / "markservo-XXXXXX").string();
    if (::mkdtemp(folder.data()) == nullptr) throw ConfigurationError(folder + ": cannot be made; allowed: a TMPDIR");
    folder_ = folder;
    std::ofstream(path(), std::ios::binary) << text;
  }
  ~PassingFile() {
    std::error_code none;
    fs::remove_all(folder_, none);
  }
  PassingFile(const PassingFile&) = delete;
  PassingFile& operator=(const PassingFile&) = delete;

  std::string path() const { return (folder_ / "robot.yaml").string(); }

 private:
  fs::path folder_;
};

robot::RobotDescription description_of(const std::string& text, const std::string& manifest) {
  const PassingFile file(text);
  try {
    return robot::load_robot_description(file.path());
  } catch (const ConfigurationError& error) {
    std::string what = error.what();
    const std::size_t at = what.find(file.path());
    if (at != std::string::npos) what.replace(at, file.path().size(), manifest + ", its robot.yaml");
    throw ConfigurationError(what);
  }
}

std::string text_in(const nlohmann::json& object, const char* key) {
  const auto found = object.find(key);
  return found != object.end() && found->is_string() ? found->get<std::string>() : "";
}

}  // namespace

RecordedRobot recorded_robot(const std::string& folder) {
  const std::string manifest = folder + "/manifest.json";
  std::ifstream file(manifest);
  RecordedRobot recorded;
  if (!file) return recorded;
  try {
    const auto content = nlohmann::json::parse(file);
    recorded.robot = text_in(content, "robot");
    recorded.note = text_in(content, "note");
    const auto& configuration = content.at("configuration");
    const auto robot_file = configuration.at("robot_file").get<std::string>();
    for (const auto& entry : configuration.at("files")) {
      const auto path = entry.at("path").get<std::string>();
      if (path != robot_file) continue;
      recorded.path = path;
      recorded.description = description_of(entry.at("text").get<std::string>(), manifest);
      break;
    }
  } catch (const nlohmann::json::exception& error) {
    throw ConfigurationError(manifest + ": no manifest of a recording: " + error.what());
  }
  return recorded;
}

}  // namespace markservo::mmi
