#include "common/bus/tool.hpp"

#include <exception>
#include <iostream>

#include "common/bus/bus_unavailable.hpp"
#include "common/bus/bus_url.hpp"
#include "common/bus/command_line.hpp"
#include "common/bus/exit_code.hpp"
#include "common/robot/configuration_error.hpp"
#include "common/text/text.hpp"
#include "common/text/typed_command.hpp"

namespace markservo::bus {

void add_live_bus_option(CLI::App& app, std::string& url) {
  const auto objection = [](const std::string& given) {
    return is_udpm(given) ? std::string() : given + ": allowed is udpm://, a bus that others write on";
  };
  Options(app)
      .option("--lcm-url", url, "The bus")
      .environment("MARKSERVO_LCM_URL")
      .check(objection, "udpm://")
      .show_default();
}

int run_tool(const ToolInfo& info, int argc, char** argv, const std::function<void(CLI::App& app)>& add_options,
             const std::function<int()>& run) {
  const std::string name = text::TypedCommand(argc > 0 ? argv[0] : "").name_or(info.name);
  const auto complain = [&name](const std::exception& error, int code) {
    std::cerr << name << ": " << text::printable(error.what()) << std::endl;
    return code;
  };
  CommandLine command_line(info.name, info.description);
  add_options(command_line.app());
  try {
    if (const auto exit_code = command_line.parse(argc, argv)) return *exit_code;
    return run();
  } catch (const ConfigurationError& error) {
    return complain(error, kExitBadConfiguration);
  } catch (const BusUnavailable& error) {
    return complain(error, kExitBusUnavailable);
  } catch (const std::exception& error) {
    return complain(error, kExitFailed);
  }
}

}  // namespace markservo::bus
