#pragma once

// A program's command line: all that reading it needs of CLI11, so that one file is compiled with it.

#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "common/bus/options.hpp"

namespace markservo::bus {

class CommandLine {
 public:
  // `name`: of the executable, for --help and errors, where no command was typed that runs it (text::TypedCommand);
  // empty: as it was called. `description`: for --help.
  CommandLine(const std::string& name, const std::string& description);
  ~CommandLine();
  CommandLine(const CommandLine&) = delete;
  CommandLine& operator=(const CommandLine&) = delete;

  // What options are added to (Options).
  CLI::App& app() { return *app_; }

  // Adds --config FILE, which reads options as config_file.hpp says.
  void read_config_files();

  // Adds a command of its own options, one of which must then be given; `chosen` is called where it is this one.
  CLI::App& add_command(const std::string& name, const std::string& what, std::function<void()> chosen);

  // To be called when all options are there; they then have their values. The exit code where nothing more is to be
  // done: after --help, and for wrong options, which one line on the standard error tells.
  std::optional<int> parse(int argc, const char* const* argv);

  // All settings in force, as --config reads them.
  std::string settings() const;
  // Likewise, each under what it is for.
  std::string explained_settings() const;

 private:
  std::string name_;
  std::unique_ptr<CLI::App> app_;
};

}  // namespace markservo::bus
