// stack-watch: runs beside a stack; kills a service that hangs, so that its supervisor starts it again, and answers
// scripts/stack status.
//   in: all of the bus, supervisord's socket     out: SERVICE_STATUS, its own socket

#include <cstdint>
#include <string>

#include "common/bus/bus_url.hpp"
#include "common/bus/log_format.hpp"
#include "common/bus/options.hpp"
#include "common/bus/service.hpp"
#include "common/bus/tool.hpp"
#include "services/stack-watch/answering_device.hpp"
#include "services/stack-watch/stack_watch_node.hpp"

namespace {

namespace watch = markservo::stack_watch;

int run(const watch::StackWatchSettings& settings, const std::string& socket) {
  markservo::bus::set_up_log("stack-watch", "info");
  watch::StackWatchNode node(settings);
  const watch::AnsweringDevice answering(socket, [&node] { return node.answer(); });
  node.run();
  return markservo::bus::kExitStopped;
}

}  // namespace

int main(int argc, char** argv) {
  watch::StackWatchSettings settings;
  settings.url = markservo::bus::kDefaultUrl;
  std::string socket;
  double silence_s = 1e-6 * static_cast<double>(settings.silence.silence_us);
  const auto add_options = [&](CLI::App& app) {
    markservo::bus::add_live_bus_option(app, settings.url);
    const markservo::bus::Options add(app);
    add.option("--robot", settings.robot, "Prefix of all channels, for several robots on one bus");
    add.option("--supervisor", settings.supervisor, "supervisord's socket").required();
    add.option("--socket", socket, "Where it answers").required();
    add.option("--silence", silence_s,
               "A service that spoke and then says nothing for so long is killed, s (for its first word: 15 s)")
        .within(2.0, 3600.0)
        .show_default();
  };
  return markservo::bus::run_tool(
      {"stack-watch", "Runs beside a stack: kills a service that hangs, and tells how all are"}, argc, argv,
      add_options, [&] {
        settings.silence.silence_us = static_cast<std::int64_t>(1e6 * silence_s);
        return run(settings, socket);
      });
}
