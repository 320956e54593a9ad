#include "services/recorder/recorder_options.hpp"

#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <map>
#include <set>
#include <string_view>

#include "common/bus/bus_url.hpp"
#include "services/recorder/logger/logger_arguments.hpp"
#include "services/recorder/plain_path.hpp"
#include "services/recorder/refusal.hpp"

namespace markservo::recorder {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kDigits = "0123456789";
constexpr std::string_view kLetters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz";

// Some are a script's, not a person's: where things are, and --new-folder.
const std::set<std::string> kFlags = {"--without-frames", "--installed", "--new-folder"};
const std::set<std::string> kOptions = {"--for",    "--split-mb", "--keep",       "--min-free",   "--name",
                                        "--out",    "--note",     "--lcm-url",    "--robot",      "--robot-file",
                                        "--finish", "--project",  "--config-dir", "--get-logger", "--logs-dir"};

// What was given, as it was given.
class Given {
 public:
  explicit Given(const std::vector<std::string>& words) {
    for (std::size_t i = 0; i < words.size(); ++i) {
      if (kFlags.count(words[i]) > 0) {
        values_[words[i]] = "";
        continue;
      }
      const std::size_t equals = words[i].rfind("--", 0) == 0 ? words[i].find('=') : std::string::npos;
      const std::string name = words[i].substr(0, equals);
      const bool needs_next = equals == std::string::npos;
      if (needs_next && name.rfind('-', 0) == 0 && i + 1 == words.size()) throw UsageError(name + " needs a value");
      if (kOptions.count(name) == 0) throw UsageError("unknown argument '" + name + "'");
      values_[name] = needs_next ? words[++i] : words[i].substr(equals + 1);
    }
  }

  bool has(const char* name) const { return values_.count(name) > 0; }

  void text(const char* name, std::string* value) const {
    if (has(name)) *value = values_.at(name);
  }

  std::optional<std::int64_t> whole(const char* name, std::int64_t least, std::int64_t most) const {
    if (!has(name)) return std::nullopt;
    const std::string& text = values_.at(name);
    std::int64_t number = least - 1;
    const bool digits = !text.empty() && text.find_first_not_of(kDigits) == std::string::npos;
    const auto result = std::from_chars(text.data(), text.data() + text.size(), number);
    if (!digits || result.ec != std::errc() || number < least || number > most) {
      throw UsageError(std::string(name) + " " + text + "; allowed: " + std::to_string(least) + " to " +
                       std::to_string(most));
    }
    return number;
  }

 private:
  std::map<std::string, std::string> values_;
};

bool consists_of(std::string_view text, std::string_view more) {
  return std::all_of(text.begin(), text.end(), [more](char c) {
    return kLetters.find(c) != std::string_view::npos || kDigits.find(c) != std::string_view::npos ||
           more.find(c) != std::string_view::npos;
  });
}

bool is_folder_name(const std::string& name) {
  return consists_of(name, "._-") && consists_of(name.substr(0, 1), "") && name != "latest";
}

void check(const RecorderOptions& options) {
  const RecordingPlan& plan = options.plan;
  const Places& places = options.places;
  if (plan.keep_parts && !plan.split_mb) throw UsageError("--keep needs --split-mb");
  if (!options.name.empty() && !options.out.empty()) throw UsageError("--name and --out: one of them");
  if (!options.name.empty() && !is_folder_name(options.name)) {
    throw UsageError("--name '" + options.name + "'; allowed: letters, digits, . _ and -, but not 'latest'");
  }
  if (!consists_of(plan.robot, "_-")) {
    throw UsageError("--robot '" + plan.robot + "'; allowed: letters, digits, _ and -");
  }
  if (!bus::is_udpm(plan.lcm_url) && !bus::is_tcpq(plan.lcm_url)) {
    throw UsageError("--lcm-url '" + plan.lcm_url + "'; allowed: udpm:// and tcpq:// URLs");
  }
  std::error_code error;
  if (!fs::is_regular_file(places.robot_file, error)) {
    throw UsageError("--robot-file " + places.robot_file + ": no such file");
  }
  if (access(places.robot_file.c_str(), R_OK) != 0) {
    throw UsageError("--robot-file " + places.robot_file + ": cannot be read");
  }
  if (!fs::is_directory(places.config_dir, error)) {
    throw UsageError("--config-dir " + places.config_dir + ": no such folder");
  }
}

RecordingPlan plan_of(const Given& given, const std::string& default_url) {
  RecordingPlan plan;
  plan.lcm_url = default_url;
  given.text("--lcm-url", &plan.lcm_url);
  given.text("--robot", &plan.robot);
  given.text("--note", &plan.note);
  plan.frames = !given.has("--without-frames");
  plan.duration_s = given.whole("--for", 1, 99'999'999);
  plan.split_mb = given.whole("--split-mb", 1, 1'000'000);
  plan.keep_parts = given.whole("--keep", 1, 100'000);
  plan.min_free_mb = given.whole("--min-free", 0, 99'999'999).value_or(plan.min_free_mb);
  return plan;
}

}  // namespace

RecorderOptions parse_command_line(const std::vector<std::string>& words, const std::string& default_url) {
  const Given given(words);
  RecorderOptions options;
  options.plan = plan_of(given, default_url);
  given.text("--project", &options.places.project);
  given.text("--logs-dir", &options.places.logs_dir);
  given.text("--config-dir", &options.places.config_dir);
  given.text("--robot-file", &options.places.robot_file);
  given.text("--get-logger", &options.commands.get_logger);
  given.text("--name", &options.name);
  given.text("--out", &options.out);
  given.text("--finish", &options.finish);
  options.places.installed = given.has("--installed");
  options.new_folder = given.has("--new-folder");
  if (!options.new_folder) check(options);
  options.places.project = plain_path(options.places.project);
  options.places.logs_dir = plain_path(options.places.logs_dir);
  options.plan.lcm_url = with_receive_buffer(options.plan.lcm_url);
  return options;
}

}  // namespace markservo::recorder
