#pragma once

// How --config reads a file: a flat list of key=value lines, keys as the options' long names.
//
//   # a comment                   robot-file=/home of/robot.yaml   # one behind a value begins after a space
//   speed=0.5                     send=STOP                        # an option that takes many: a line for each,
//   quiet                         send=[STOP, TASK_STATE]          # or a list
//
// A value may hold spaces, and may stand in quotes; an empty one in quotes leaves the option as it is. A line is a
// setting: no list goes over several, and none begins with ';'.

#include <CLI/CLI.hpp>
#include <iosfwd>
#include <vector>

namespace markservo::bus {

class ConfigFile : public CLI::ConfigBase {
 public:
  // `app` must outlive this.
  explicit ConfigFile(const CLI::App& app) : app_(&app) {}

  // Throws CLI::ConfigError, with file, line, key and what is allowed, for a key that is no option's or that stands
  // twice though its option takes one value.
  std::vector<CLI::ConfigItem> from_config(std::istream& input) const override;

 private:
  const CLI::App* app_;
};

}  // namespace markservo::bus
