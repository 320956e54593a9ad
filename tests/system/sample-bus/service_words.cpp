// What somebody may say in a service's name: SERVICE_STATUS of this host at 5 Hz for --for seconds.

#include <CLI/CLI.hpp>
#include <chrono>
#include <cstdint>
#include <lcm/lcm-cpp.hpp>
#include <markservo/ServiceStatus.hpp>
#include <string>
#include <thread>
#include <vector>

#include "common/bus/bus_url.hpp"
#include "common/bus/host_name.hpp"
#include "common/bus/session.hpp"
#include "common/time/clocks.hpp"

int main(int argc, char** argv) {
  std::string url = markservo::bus::kDefaultUrl;
  std::string channel = "SERVICE_STATUS";
  double seconds = 1.0;
  markservo::ServiceStatus status{};
  status.host = markservo::bus::host_name();
  status.session = markservo::bus::random_session();
  CLI::App app("Speaks in a service's name", "service-words");
  app.add_option("--lcm-url", url, "The bus")->envname("MARKSERVO_LCM_URL");
  app.add_option("--channel", channel, "Where")->capture_default_str();
  app.add_option("--name", status.name, "The service")->required();
  app.add_option("--pid", status.pid, "Its process")->required();
  app.add_option("--state", status.state, "How it is")->required();
  app.add_option("--for", seconds, "s")->capture_default_str();
  CLI11_PARSE(app, argc, argv);
  lcm::LCM lcm(url);
  if (!lcm.good()) return 3;
  for (int i = 0; i < static_cast<int>(5.0 * seconds); ++i) {
    status.utime = markservo::wall_clock_us();
    ++status.seq;
    std::vector<std::uint8_t> bytes(static_cast<std::size_t>(status.getEncodedSize()));
    status.encode(bytes.data(), 0, static_cast<int>(bytes.size()));
    lcm.publish(channel, bytes.data(), static_cast<unsigned int>(bytes.size()));
    std::this_thread::sleep_for(std::chrono::milliseconds(200));
  }
  return 0;
}
