#pragma once

// What can be asked of log-tool.

#include <string>
#include <vector>

#include "common/bus/command_line.hpp"
#include "common/text/typed_command.hpp"
#include "services/log-tool/event_choice.hpp"
#include "services/log-tool/log_comparison.hpp"
#include "services/log-tool/play_node.hpp"

namespace markservo::log_tool {

struct Options {
  std::vector<std::string> inputs;
  std::string input;
  std::string other;
  std::string output;
  std::vector<std::string> types;  // files and folders of another system's
  bool json = false;
  bool exact = false;
  bool complete = false;
  EventChoice choice;
  ComparisonParameters comparison;
  PlayOptions play;
};

// Does what one command asks for; returns the exit code.
using Action = int (*)(const Options&);

struct Actions {
  Action info;
  Action verify;
  Action types;
  Action repair;
  Action cut;
  Action merge;
  Action sort;
  Action splice;
  Action export_log;
  Action extract_config;
  Action compare;
  Action play;
};

// The commands and their options.
class Commands {
 public:
  // `typed`: by what name a person knows this tool.
  Commands(bus::CommandLine& command_line, const text::TypedCommand& typed, const Actions& actions);

  // Does the one that was chosen.
  int run() const { return action_(options_); }

 private:
  bus::Options command(const char* name, const char* what, Action action);
  void add_choice(const bus::Options& add);
  void add_types(const bus::Options& add);
  void add_readers(const Actions& actions);
  void add_writers(const Actions& actions);
  void add_joiners(const Actions& actions);
  void add_comparison(const Actions& actions);
  void add_player(const Actions& actions);

  bus::CommandLine* command_line_;
  Options options_;
  Action action_ = nullptr;
};

}  // namespace markservo::log_tool
