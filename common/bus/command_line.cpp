#include "common/bus/command_line.hpp"

#include <iostream>
#include <utility>

#include "common/bus/config_file.hpp"
#include "common/bus/exit_code.hpp"
#include "common/bus/option_checks.hpp"
#include "common/text/text.hpp"
#include "common/text/typed_command.hpp"

namespace markservo::bus {
namespace {

std::string one_line(std::string text) {
  while (!text.empty() && text.back() == '\n') text.pop_back();
  for (char& character : text) {
    if (character == '\n') character = ' ';
  }
  return text;
}

}  // namespace

CommandLine::CommandLine(const std::string& name, const std::string& description)
    : name_(name), app_(std::make_unique<CLI::App>(description, name)) {}

CommandLine::~CommandLine() = default;

void CommandLine::read_config_files() {
  app_->config_formatter(std::make_shared<ConfigFile>(*app_));
  app_->set_config("--config", "", "Read options from this file (key=value lines, keys as the options' names)");
  app_->allow_config_extras(CLI::config_extras_mode::error);
}

CLI::App& CommandLine::add_command(const std::string& name, const std::string& what, std::function<void()> chosen) {
  app_->require_subcommand(1);
  CLI::App* command = app_->add_subcommand(name, what);
  command->callback(std::move(chosen));
  return *command;
}

std::optional<int> CommandLine::parse(int argc, const char* const* argv) {
  require_decimal_numbers(*app_);
  const text::TypedCommand typed(argc > 0 ? argv[0] : "");
  const std::string name = typed.name_or(name_);
  const std::string call = typed.call_or(name_);
  if (!call.empty()) app_->name(call);
  try {
    app_->parse(argc, argv);
  } catch (const CLI::Success& request) {
    return app_->exit(request);
  } catch (const CLI::Error& error) {
    const std::string what = text::printable(one_line(error.what()));
    std::cerr << name << (name.empty() ? "" : ": ") << what << "; see " << call << (call.empty() ? "" : " ")
              << "--help\n";
    return kExitBadConfiguration;
  }
  return std::nullopt;
}

std::string CommandLine::settings() const {
  return app_->config_to_str(true);
}

std::string CommandLine::explained_settings() const {
  return app_->config_to_str(true, true);
}

}  // namespace markservo::bus
