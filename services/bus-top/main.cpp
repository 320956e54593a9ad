// Shows what is on the bus, in a terminal or as plain text.
//   in: all channels     out: the terminal, text or JSON

#include <cstdio>
#include <exception>

#include "common/bus/service.hpp"
#include "services/bus-top/bus_top_node.hpp"
#include "services/bus-top/screen.hpp"

int main(int argc, char** argv) {
  using namespace markservo;
  CLI::App app("Shows every channel on the bus: type, rate, losses, and the newest message's fields", "bus-top");
  bus_top::BusTopOptions options;
  bus_top::add_options(app, options);
  const auto complain = [](const std::exception& error, int code) {
    std::fprintf(stderr, "bus-top: %s\n", error.what());
    return code;
  };
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& request) {
    return app.exit(request);
  } catch (const CLI::Error& error) {
    return complain(error, bus::kExitBadConfiguration);
  }
  try {
    return bus_top::BusTopNode(options).run();
  } catch (const bus_top::NoTerminal& error) {
    return complain(error, bus::kExitBadConfiguration);
  } catch (const bus::BusUnavailable& error) {
    return complain(error, bus::kExitBusUnavailable);
  } catch (const std::exception& error) {
    return complain(error, bus::kExitFailed);
  }
}
