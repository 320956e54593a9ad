// bus-census: listens for a moment and tells who is on the bus and what each writes.
//   in: all channels     out: standard output

#include <CLI/CLI.hpp>
#include <cmath>
#include <iostream>

#include "common/bus/network_check.hpp"
#include "common/bus/service.hpp"
#include "services/bus-census/bus_census_node.hpp"
#include "services/bus-census/census_text.hpp"
#include "services/bus-census/clock_reader.hpp"

namespace {

namespace census = markservo::bus_census;
using Json = nlohmann::ordered_json;

struct Options {
  std::string url = markservo::bus::kDefaultUrl;
  double seconds = 1.5;  // every service speaks once a second
  bool json = false;
  bool follow = false;
};

void print(const Json& json) {
  std::cout << json.dump(-1, ' ', false, Json::error_handler_t::replace) << std::endl;
}

Json receive_buffer() {
  constexpr int64_t kAsked = 4'194'304;  // bytes, as the default URL does
  const auto granted = markservo::bus::granted_receive_buffer(kAsked);
  return {{"asked", kAsked},
          {"granted", granted ? Json(*granted) : Json()},
          {"raw_frames_need", markservo::bus::kReceiveBufferForRawFrames}};
}

int run(const Options& options) {
  census::BusCensusNode node(options.url, options.follow);
  if (options.follow) {
    node.on_status = [](const census::ServiceWord& word) { print(json_of(word)); };
    print({{"listening", options.url}});
  }
  const int64_t wall_us = census::wall_clock_us();
  const int64_t steady_us = census::steady_clock_us();
  node.listen(options.seconds);
  const int64_t jump_us = (census::wall_clock_us() - wall_us) - (census::steady_clock_us() - steady_us);
  if (options.follow) return markservo::bus::kExitStopped;
  if (!options.json) {
    std::cout << table_of(node.report());
    return markservo::bus::kExitStopped;
  }
  Json json = {
      {"url", options.url},
      {"host", census::host_name()},
      {"version", MARKSERVO_VERSION},
      {"raw_frames_fit", markservo::bus::raw_frames_fit(options.url)},
      {"receive_buffer", receive_buffer()},
      {"clock", {{"synchronised", census::clock_is_synchronised()}, {"jump_s", 1e-6 * static_cast<double>(jump_us)}}}};
  json.update(json_of(node.report()));
  print(json);
  return markservo::bus::kExitStopped;
}

std::string bad_url(const std::string& url) {
  if (markservo::bus::is_udpm(url)) return {};
  return "a bus that others are on begins with udpm://";
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Listens for a moment and tells who is on the bus: services (SERVICE_STATUS) and channels",
               "bus-census");
  Options options;
  app.add_option("--lcm-url", options.url, "The bus")
      ->envname("MARKSERVO_LCM_URL")
      ->check(CLI::Validator(bad_url, "udpm://"))
      ->capture_default_str();
  app.add_option("--for", options.seconds, "Listen so long, s")->check(CLI::Range(0.1, 3600.0))->capture_default_str();
  auto* json = app.add_flag("--json", options.json, "One JSON object instead of tables");
  app.add_flag("--follow", options.follow, "Print each SERVICE_STATUS instead when it comes, one JSON object a line")
      ->excludes(json);
  try {
    app.parse(argc, argv);
    return run(options);
  } catch (const CLI::Success& request) {
    return app.exit(request);
  } catch (const CLI::Error& error) {
    std::cerr << "bus-census: " << error.what() << "; see bus-census --help\n";
    return markservo::bus::kExitBadConfiguration;
  } catch (const markservo::bus::BusUnavailable& error) {
    std::cerr << "bus-census: " << error.what() << "\n";
    return markservo::bus::kExitBusUnavailable;
  } catch (const std::exception& error) {
    std::cerr << "bus-census: " << error.what() << "\n";
    return markservo::bus::kExitFailed;
  }
}
