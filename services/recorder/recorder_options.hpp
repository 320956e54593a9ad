#pragma once

#include <string>
#include <vector>

#include "services/recorder/recording_plan.hpp"

namespace markservo::recorder {

// Where a recorder's files are.
struct Places {
  std::string project = ".";  // what is below is named relative to it; absolute once parsed
  std::string logs_dir = "logs";
  std::string config_dir = "config";
  std::string robot_file = "config/robot.yaml";
  bool installed = false;  // there are no sources, whose version could be asked
};

// What a person types, for the words that name it.
struct CommandNames {
  std::string record = "scripts/record";
  std::string log = "scripts/log";
  std::string get_logger = "scripts/install";  // what installs lcm-logger
};

struct RecorderOptions {
  RecordingPlan plan;
  Places places;
  CommandNames commands;
  std::string name;         // of the folder, in logs_dir
  std::string out;          // or any folder
  std::string finish;       // instead: complete the manifest there
  bool new_folder = false;  // instead: make a folder for whoever records into it later
};

// `words`: the command line without the program. Of an option that is given twice the last counts. The bus that nobody
// names is `default_url`. Throws UsageError.
RecorderOptions parse_command_line(const std::vector<std::string>& words, const std::string& default_url);

}  // namespace markservo::recorder
