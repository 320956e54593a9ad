#include "services/recorder/manifest/configuration.hpp"

#include <glib.h>

#include <memory>

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

}  // namespace

std::string kept_path(const std::string& file, const std::string& config_dir, const std::string& project) {
  if (is_below(file, config_dir)) return "config/" + file.substr(config_dir.size() + 1);
  if (is_below(file, project)) return file.substr(project.size() + 1);
  return "outside/" + file.substr(file.rfind('/') + 1);
}

Json configuration_json(const std::vector<ConfigurationFile>& files) {
  Json list = Json::array();
  std::string sums;  // as sha256sum prints them
  for (const ConfigurationFile& file : files) {
    const std::string sum = sha256(file.text);
    sums += sum + "  " + file.path + "\n";
    list.push_back({{"path", file.path}, {"sha256", sum}, {"text", file.text}});
  }
  return {{"sha256", sha256(sums)}, {"files", list}};
}

}  // namespace markservo::recorder
