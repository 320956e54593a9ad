// recorder: records the bus into a folder, with lcm-logger, and keeps its manifest; scripts/record runs it.
//   in: all of the bus     out: log.lcm, manifest.json, a line of what happens

#include <algorithm>
#include <cstdlib>
#include <string>
#include <vector>

#include "common/bus/bus_url.hpp"
#include "common/text/typed_command.hpp"
#include "services/recorder/finish_node.hpp"
#include "services/recorder/logger/keep_logger_node.hpp"
#include "services/recorder/logger/logger_names.hpp"
#include "services/recorder/places_node.hpp"
#include "services/recorder/process.hpp"
#include "services/recorder/recorder_node.hpp"
#include "services/recorder/recorder_options.hpp"
#include "services/recorder/refusal.hpp"
#include "services/recorder/terminal.hpp"

namespace {

namespace recorder = markservo::recorder;

int run(const recorder::RecorderOptions& options) {
  if (!options.finish.empty()) {
    recorder::finish_recording(options);
    return 0;
  }
  recorder::SignalQueue signals;
  if (options.new_folder) {
    const auto folder = recorder::new_dated_folder(options.places.logs_dir, signals);
    recorder::point_latest_to(options.places.logs_dir, folder.name());
    recorder::say(folder.path());
    return 0;
  }
  if (!recorder::is_in_path(recorder::kLcmLogger)) {
    throw recorder::Refusal(1, "lcm-logger is not installed: run " + options.commands.get_logger);
  }
  return recorder::RecorderNode(options, signals).run();
}

std::string default_url() {
  const char* url = std::getenv("MARKSERVO_LCM_URL");
  return url != nullptr && *url != '\0' ? url : markservo::bus::kDefaultUrl;
}

}  // namespace

int main(int argc, char** argv) {
  const std::vector<std::string> words(argv + std::min(argc, 1), argv + argc);
  const markservo::text::TypedCommand typed(argc > 0 ? argv[0] : "");
  try {
    recorder::open_standard_descriptors();
    if (!words.empty() && words[0] == recorder::kKeepLogger)
      return recorder::keep_logger({words.begin() + 1, words.end()});
    recorder::RecorderOptions options = recorder::parse_command_line(words, default_url());
    options.commands.record = typed.of("record");
    options.commands.log = typed.of("log");
    return run(options);
  } catch (const recorder::UsageError& error) {
    recorder::warn(std::string(error.what()) + "; see " + typed.of("record") + " --help");
    return error.code();
  } catch (const recorder::Refusal& error) {
    if (*error.what() != '\0') recorder::warn(error.what());
    return error.code();
  } catch (const std::exception& error) {
    recorder::warn(error.what());
    return 1;
  }
}
