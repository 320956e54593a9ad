// A crowd on the bus, once a second until it is told to stop: SERVICE_STATUS of --services services of each of --robots
// robots, and --channels more channels with a JOINT_STATE each. Says "crowded" when all have spoken once.

#include <CLI/CLI.hpp>
#include <chrono>
#include <csignal>
#include <cstdint>
#include <cstdio>
#include <lcm/lcm-cpp.hpp>
#include <markservo/JointState.hpp>
#include <markservo/ServiceStatus.hpp>
#include <string>
#include <thread>
#include <vector>

#include "common/bus/bus_url.hpp"
#include "common/time/clocks.hpp"

namespace {

volatile std::sig_atomic_t signalled = 0;

struct Options {
  std::string url = markservo::bus::kDefaultUrl;
  int robots = 100;
  int services = 8;
  int channels = 2000;
};

template <class M>
void send(lcm::LCM* lcm, const std::string& channel, const M& message) {
  std::vector<std::uint8_t> bytes(static_cast<std::size_t>(message.getEncodedSize()));
  message.encode(bytes.data(), 0, static_cast<int>(bytes.size()));
  lcm->publish(channel, bytes.data(), static_cast<unsigned int>(bytes.size()));
}

void send_status(lcm::LCM* lcm, int robot, int service, std::int64_t round) {
  markservo::ServiceStatus status{};
  status.utime = markservo::wall_clock_us();
  status.session = 1 + 1000 * robot + service;
  status.seq = round;
  // Some have the names that ours have.
  status.name = service == 0 ? "mark-watcher" : "service-" + std::to_string(service);
  status.host = "host-" + std::to_string(robot);
  status.pid = 100 + service;
  status.version = "0.1.0";
  status.state = "ready";
  for (int i = 0; i < 10; ++i) {
    markservo::ChannelStatus channel{};
    channel.channel = "CHANNEL_" + std::to_string(i);
    channel.received = round;
    status.channels.push_back(channel);
  }
  status.num_channels = static_cast<std::int32_t>(status.channels.size());
  send(lcm, "r" + std::to_string(robot) + "/SERVICE_STATUS", status);
}

void send_round(lcm::LCM* lcm, const Options& options, std::int64_t round) {
  int sent = 0;
  // In small groups: a real crowd does not speak all at once.
  const auto pause = [&sent] {
    if (++sent % 20 == 0) std::this_thread::sleep_for(std::chrono::milliseconds(5));
  };
  for (int robot = 0; robot < options.robots; ++robot) {
    for (int service = 0; service < options.services; ++service, pause()) send_status(lcm, robot, service, round);
  }
  for (int channel = 0; channel < options.channels; ++channel, pause()) {
    markservo::JointState joints{};
    joints.utime = markservo::wall_clock_us();
    joints.session = 1'000'000 + channel;
    joints.seq = round;
    send(lcm, "r" + std::to_string(channel % 100) + "/CHANNEL_OF_A_CROWD_" + std::to_string(channel), joints);
  }
}

}  // namespace

int main(int argc, char** argv) {
  Options options;
  CLI::App app("A crowd of services and channels on the bus", "bus-crowd");
  app.add_option("--lcm-url", options.url, "The bus")->envname("MARKSERVO_LCM_URL");
  app.add_option("--robots", options.robots, "How many")->capture_default_str();
  app.add_option("--services", options.services, "Of each robot")->capture_default_str();
  app.add_option("--channels", options.channels, "Beside those of services")->capture_default_str();
  CLI11_PARSE(app, argc, argv);
  std::signal(SIGTERM, [](int) { signalled = 1; });
  lcm::LCM lcm(options.url);
  if (!lcm.good()) return 3;
  for (std::int64_t round = 1; signalled == 0; ++round) {
    send_round(&lcm, options, round);
    if (round == 1) std::puts("crowded");
    std::fflush(stdout);
    std::this_thread::sleep_for(std::chrono::milliseconds(200));
  }
  return 0;
}
