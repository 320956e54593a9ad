#include "common/bus/service.hpp"

#include <malloc.h>

#include <cstdint>
#include <fstream>
#include <iostream>
#include <markservo/ServiceStatus.hpp>
#include <memory>
#include <sstream>

#include "common/bus/command_line.hpp"
#include "common/bus/log_format.hpp"
#include "common/bus/named_bus.hpp"
#include "common/bus/session.hpp"
#include "common/logging/log.hpp"
#include "common/robot/configuration_error.hpp"
#include "common/text/text.hpp"
#include "common/text/typed_command.hpp"

namespace markservo::bus {
namespace {

struct CommonOptions {
  std::string robot_file = "config/robot.yaml";
  std::string robot;
  std::string lcm_url = kDefaultUrl;
  std::string lcm_in;
  std::string lcm_out;
  std::string log_level = "info";
  bool print_config = false;
  bool check = false;
  bool list_channels = false;
};

void add_common_options(CommandLine& command_line, CommonOptions& options) {
  command_line.read_config_files();
  const Options add(command_line.app());
  add.flag("--print-config", options.print_config, "Print all settings in force and exit").not_in_config();
  add.flag("--check", options.check, "Say whether the settings and the files they name are valid, and exit")
      .not_in_config();
  add.flag("--list-channels", options.list_channels, "Print the channels that it reads and writes, and exit")
      .not_in_config();
  add.option("--robot-file", options.robot_file, "The robot's description")
      .environment("MARKSERVO_ROBOT_FILE")
      .show_default();
  add.option("--robot", options.robot, "Prefix of all channels, for several robots on one bus");
  add_lcm_url(add, options.lcm_url, "LCM bus to read and write");
  add.option("--lcm-in", options.lcm_in, "LCM bus to read, if another: file://LOG?speed=0 replays a log");
  add.option("--lcm-out", options.lcm_out, "LCM bus to write, if another: file://LOG?mode=w writes a log");
  add.option("--log-level", options.log_level, "Least severity that is logged to the standard error")
      .one_of({"debug", "info", "warn", "error"})
      .show_default();
}

// All that decides how the service behaves, in one number.
std::int64_t config_hash(const CommandLine& command_line, const std::string& robot_file) {
  std::ifstream file(robot_file);
  std::ostringstream content;
  content << file.rdbuf();
  return static_cast<std::int64_t>(fingerprint(content.str(), fingerprint(command_line.settings())));
}

// On a bus of its own, which nobody hears.
int list_channels(const ServiceInfo& info, Service& service) {
  BusParameters parameters;
  parameters.urls = {"memq://", "memq://"};
  parameters.service_name = info.name;
  Bus bus(parameters);
  service.start(bus);
  for (const ChannelStatus& channel : bus.status().channels) std::cout << "reads " << channel.channel << "\n";
  for (const std::string& channel : bus.advertised()) std::cout << "writes " << channel << "\n";
  return kExitStopped;
}

// A robot on another bus than usual, because of a variable that was set for other programs, is no secret.
void tell_of_lcms_variable(const BusUrls& urls) {
  const std::string& url = told_by(urls.in).empty() ? urls.out : urls.in;
  const std::string by = told_by(url);
  if (!by.empty()) logging::info("on {}{}", url, by);
}

int serve(const ServiceInfo& info, Service& service, const CommandLine& command_line, const CommonOptions& options) {
  if (options.print_config) {
    std::cout << command_line.explained_settings();
    return kExitStopped;
  }
  if (options.check) {
    service.check(options.robot_file);
    std::cout << info.name << ": the configuration is valid\n";
    return kExitStopped;
  }
  service.configure(options.robot_file);
  if (options.list_channels) return list_channels(info, service);
  if (const auto exit_code = service.run_alone(options.robot)) return *exit_code;

  BusParameters parameters;
  parameters.urls.in = options.lcm_in.empty() ? options.lcm_url : options.lcm_in;
  parameters.urls.out = options.lcm_out.empty() ? options.lcm_url : options.lcm_out;
  parameters.source = !service.reads_bus() && options.lcm_in.empty() && is_file(parameters.urls.out);
  if (parameters.source) parameters.urls.in = "memq://";
  parameters.service_name = info.name;
  parameters.robot = options.robot;
  parameters.config_hash = config_hash(command_line, options.robot_file);
  parameters.waits_for_network = service.waits_for_network();
  Bus bus(parameters);
  tell_of_lcms_variable(parameters.urls);
  service.start(bus);
  // One that waits for something has said so.
  if (bus.state() == kStarting) bus.set_state("ready");
  service.run(bus);
  bus.finish();
  return kExitStopped;
}

// A service needs the same memory again for every frame. By default glibc gives it back to the system in between, and
// taking it anew, page by page, cost a tenth of the way from frame to command.
void keep_freed_memory() {
  constexpr int kLargestOnHeap = 32 << 20;  // bytes; the most glibc allows, and above any usual frame
  constexpr int kKeptAtMost = 64 << 20;     // bytes, free at the end of the heap
  mallopt(M_MMAP_THRESHOLD, kLargestOnHeap);
  mallopt(M_TRIM_THRESHOLD, kKeptAtMost);
}

}  // namespace

int run_service(const ServiceInfo& info, Service& service, int argc, char** argv) {
  keep_freed_memory();
  CommandLine command_line(info.name, info.description);
  CommonOptions options;
  add_common_options(command_line, options);
  service.add_options(command_line.app());
  if (const auto exit_code = command_line.parse(argc, argv)) return *exit_code;
  // Standard output belongs to what a person asked for (JSON, settings).
  set_up_log(info.name, options.log_level);
  const std::string name = text::TypedCommand(argc > 0 ? argv[0] : "").name_or(info.name);
  const auto complain = [&name](const std::exception& error, int code) {
    std::cerr << name << ": " << text::printable(error.what() + told_by(error.what())) << "\n";
    return code;
  };
  try {
    return serve(info, service, command_line, options);
  } catch (const ConfigurationError& error) {
    return complain(error, kExitBadConfiguration);
  } catch (const BusUnavailable& error) {
    return complain(error, kExitBusUnavailable);
  } catch (const std::exception& error) {
    return complain(error, kExitFailed);
  }
}

}  // namespace markservo::bus
