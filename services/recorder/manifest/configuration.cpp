#include "services/recorder/manifest/configuration.hpp"

#include <glib.h>

#include <memory>
#include <set>

namespace markservo::recorder {
namespace {

std::string sha256(const std::string& text) {
  const std::unique_ptr<char, decltype(&g_free)> digest(
      g_compute_checksum_for_data(G_CHECKSUM_SHA256, reinterpret_cast<const guchar*>(text.data()), text.size()),
      &g_free);
  return digest.get();
}

bool is_below(const std::string& file, const std::string& folder) {
  return file.rfind(folder + "/", 0) == 0;
}

std::string name_of(const std::string& file) {
  return file.substr(file.rfind('/') + 1);
}

// What it is called where nobody else wants that.
std::string kept_path(const std::string& file, const ConfigurationSources& sources) {
  if (is_below(file, sources.config_dir)) return "config/" + file.substr(sources.config_dir.size() + 1);
  if (is_below(file, sources.project)) return file.substr(sources.project.size() + 1);
  return "outside/" + name_of(file);
}

// Notes in `taken` what it gets.
std::string free_path(const std::string& file, const ConfigurationSources& sources, std::set<std::string>* taken) {
  std::string path = kept_path(file, sources);
  for (int i = 1; !taken->insert(path).second; ++i) {
    path = "outside/" + (i == 1 ? "" : std::to_string(i) + "/") + name_of(file);
  }
  return path;
}

}  // namespace

std::vector<std::string> kept_paths(const std::vector<std::string>& files, const ConfigurationSources& sources) {
  std::set<std::string> taken;
  const std::string robot = free_path(sources.robot_file, sources, &taken);
  std::vector<std::string> paths;
  for (const std::string& file : files) {
    paths.push_back(file == sources.robot_file ? robot : free_path(file, sources, &taken));
  }
  return paths;
}

Json configuration_json(const std::vector<ConfigurationFile>& files, const std::string& robot_file) {
  Json list = Json::array();
  Json unreadable = Json::array();
  std::string sums;  // as sha256sum prints them
  for (const ConfigurationFile& file : files) {
    if (!file.text) {
      unreadable.push_back(file.path);
      continue;
    }
    const std::string sum = sha256(*file.text);
    sums += sum + "  " + file.path + "\n";
    list.push_back({{"path", file.path}, {"sha256", sum}, {"text", *file.text}});
  }
  return {{"sha256", sha256(sums)}, {"robot_file", robot_file}, {"files", list}, {"unreadable", unreadable}};
}

}  // namespace markservo::recorder
