// Changes the running simulated world, and returns when the simulator has obeyed; for tests.
//   simulator-set NAME=VALUE...             these settings (simulator --list-settings), from now on
//   simulator-set --reset 1 NAME=VALUE...   puts the world back first, with this seed
// Exit codes: 0 obeyed; 1 refused, or no answer within 10 s; 2 bad options; 3 no bus.

#include <CLI/CLI.hpp>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <markservo/SimControl.hpp>
#include <markservo/SimTruth.hpp>
#include <optional>
#include <string>
#include <vector>

#include "common/bus/bus.hpp"
#include "common/bus/bus_unavailable.hpp"
#include "common/bus/bus_url.hpp"

namespace markservo {
namespace {

using std::chrono::milliseconds;
using std::chrono::steady_clock;

constexpr milliseconds kListen(20);
constexpr milliseconds kRepeat(200);
constexpr std::chrono::seconds kPatience(10);

SimControl control_of(const std::vector<std::string>& settings, const std::optional<std::int64_t>& seed) {
  SimControl control{};
  control.kind = seed ? SimControl::RESET : SimControl::SET;
  control.control_id = 1;
  control.seed = seed.value_or(0);
  for (const std::string& setting : settings) {
    const std::size_t equals = setting.find('=');
    char* end = nullptr;
    SimParameter parameter;
    parameter.name = setting.substr(0, equals);
    const std::string value = equals == std::string::npos ? "" : setting.substr(equals + 1);
    parameter.value = std::strtod(value.c_str(), &end);
    if (value.empty() || *end != '\0') throw CLI::ValidationError(setting + "; allowed: NAME=NUMBER");
    control.parameters.push_back(parameter);
  }
  control.num_parameters = static_cast<std::int32_t>(control.parameters.size());
  return control;
}

int ask(SimControl control) {
  const char* given = std::getenv("LCM_DEFAULT_URL");
  const std::string url = given == nullptr || *given == '\0' ? bus::kDefaultUrl : given;
  bus::BusParameters parameters;
  parameters.urls = {url, url};
  parameters.service_name = "simulator-set";
  parameters.heartbeat = false;
  bus::Bus bus(parameters);
  auto controls = bus.advertise(channels::kSimControl);
  control.session = controls.session();
  std::optional<SimTruth> truth;
  bus.on_each(channels::kSimTruth, [&](const SimTruth& heard) { truth = heard; });
  const auto begin = steady_clock::now();
  auto next = begin;
  while (steady_clock::now() - begin < kPatience) {
    bus.poll(kListen);
    if (!truth) continue;
    if (truth->control_session == control.session && truth->control_id == control.control_id) {
      if (truth->control_error.empty()) return 0;
      std::fprintf(stderr, "simulator-set: refused: %s\n", truth->control_error.c_str());
      return 1;
    }
    if (steady_clock::now() < next) continue;
    next = steady_clock::now() + kRepeat;
    control.utime = truth->utime;  // anew each time: an old one is refused
    controls.publish(control);
  }
  std::fprintf(stderr, "simulator-set: %s\n", truth ? "not obeyed within 10 s" : "no SIM_TRUTH within 10 s");
  return 1;
}

}  // namespace
}  // namespace markservo

int main(int argc, char** argv) {
  CLI::App app("Changes the running simulated world");
  std::vector<std::string> settings;
  std::optional<std::int64_t> seed;
  app.add_option("settings", settings, "NAME=VALUE, as simulator --list-settings names them");
  app.add_option("--reset", seed, "Put the world back first, with this seed");
  try {
    app.parse(argc, argv);
    return markservo::ask(markservo::control_of(settings, seed));
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  } catch (const markservo::bus::BusUnavailable& error) {
    std::fprintf(stderr, "simulator-set: %s\n", error.what());
    return 3;
  }
}
