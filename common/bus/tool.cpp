#include "common/bus/tool.hpp"

#include <iostream>

#include "common/bus/number_options.hpp"
#include "common/bus/service.hpp"
#include "common/robot/configuration_error.hpp"
#include "common/text/text.hpp"

namespace markservo::bus {

void add_live_bus_option(CLI::App& app, std::string& url) {
  const auto objection = [](const std::string& given) {
    return is_udpm(given) ? std::string() : given + ": allowed is udpm://, a bus that others write on";
  };
  app.add_option("--lcm-url", url, "The bus")
      ->envname("MARKSERVO_LCM_URL")
      ->check(CLI::Validator(objection, "udpm://"))
      ->capture_default_str();
}

int run_tool(CLI::App& app, int argc, char** argv, const std::function<int()>& run) {
  const auto complain = [&app](const std::exception& error, int code, const std::string& more = {}) {
    std::cerr << app.get_name() << ": " << text::printable(error.what()) << more << std::endl;
    return code;
  };
  require_decimal_numbers(app);
  try {
    app.parse(argc, argv);
    return run();
  } catch (const CLI::Success& request) {
    return app.exit(request);
  } catch (const CLI::Error& error) {
    return complain(error, kExitBadConfiguration, "; see " + app.get_name() + " --help");
  } catch (const ConfigurationError& error) {
    return complain(error, kExitBadConfiguration);
  } catch (const BusUnavailable& error) {
    return complain(error, kExitBusUnavailable);
  } catch (const std::exception& error) {
    return complain(error, kExitFailed);
  }
}

}  // namespace markservo::bus
