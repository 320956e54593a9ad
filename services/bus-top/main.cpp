// Shows what is on the bus, in a terminal or as plain text.
//   in: all channels     out: the terminal, text or JSON

#include "common/bus/tool.hpp"
#include "services/bus-top/bus_top_node.hpp"

int main(int argc, char** argv) {
  using namespace markservo;
  bus_top::BusTopOptions options;
  return bus::run_tool(
      {"bus-top", "Shows every channel on the bus: type, rate, losses, and the newest message's fields"}, argc, argv,
      [&options](CLI::App& app) { bus_top::add_options(app, options); },
      [&options] { return bus_top::BusTopNode(options).run(); });
}
