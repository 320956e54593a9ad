#include "services/simulator/node/simulator_node.hpp"

#include <algorithm>
#include <iostream>
#include <stdexcept>

#include "common/bus/network_check.hpp"
#include "common/logging/log.hpp"
#include "common/robot/configuration_error.hpp"
#include "common/time/clocks.hpp"
#include "services/simulator/node/lockstep_node.hpp"
#include "services/simulator/node/real_time_node.hpp"
#include "services/simulator/time/awaited_channels.hpp"

namespace markservo::simulator {

void SimulatorNode::configure(const std::string& robot_file) {
  robot_file_ = robot_file;
  robot_ = robot::load_robot_description(robot_file);
  scene_ = load_scene(options_.scene_file, robot_);
  settings_ = default_settings(robot_, scene_, options_.lockstep);
  for (const std::string& assignment : options_.assignments) set_from_text(settings_, assignment);
  check_against_robot(settings_, robot_);
  const auto& awaited = options_.wait_for;
  if (options_.lockstep && !robot_.base && std::any_of(awaited.begin(), awaited.end(), answers_odometry)) {
    throw ConfigurationError("--wait-for names an answer to WHEEL_ODOMETRY; allowed: with section 'base' in " +
                             robot_file);
  }
  if (options_.list_settings || !options_.pictures.print_mark.empty()) return;
  try {
    cameras_ = std::make_unique<Cameras>();
  } catch (const std::runtime_error& error) {
    throw ConfigurationError(error.what());
  }
}

std::unique_ptr<Simulation> SimulatorNode::new_simulation(Timing timing, std::int64_t session,
                                                          std::int64_t epoch) const {
  return std::make_unique<Simulation>(robot_, scene_, settings_, static_cast<std::uint64_t>(options_.seed), timing,
                                      session, epoch);
}

std::optional<int> SimulatorNode::run_alone(const std::string& /*robot*/) {
  if (options_.list_settings) {
    std::cout << list_settings(settings_);
    return bus::kExitStopped;
  }
  if (!options_.pictures.print_mark.empty()) {
    write_print_sheet(options_.pictures, robot_, robot_file_, scene_);
    return bus::kExitStopped;
  }
  if (options_.pictures.snapshot.empty()) return std::nullopt;
  simulation_ = new_simulation(Timing::kLockstep, 0, kEpoch_us);
  simulation_->expose(1);
  simulation_->world().truth();
  const ImagePair images = exposed_frame(*simulation_, *cameras_);
  write_snapshot(options_.pictures, images.left, images.right);
  return bus::kExitStopped;
}

void SimulatorNode::start(bus::Bus& bus) {
  // In real time commands are judged by the wall clock, so that an old recording's are old to a young world too.
  simulation_ = options_.lockstep ? new_simulation(Timing::kLockstep, bus.session(), kEpoch_us)
                                  : new_simulation(Timing::kRealTime, bus.session(), wall_clock_us());
  const AwaitedChannels awaited = options_.lockstep ? awaited_channels(options_.wait_for) : AwaitedChannels{};
  world_ = std::make_unique<WorldNode>(bus, *simulation_, *cameras_, awaited, jpeg_quality(bus.urls()));
  // The first picture takes some 0.4 s: here, not when time already runs.
  simulation_->world().truth();
  exposed_frame(*simulation_, *cameras_);
}

int SimulatorNode::jpeg_quality(const bus::BusUrls& urls) const {
  if (options_.encoding == "raw") return 0;
  if (options_.encoding == "jpeg") return options_.jpeg_quality;
  const std::string obstacle = bus::raw_frames_obstacle(urls.out);
  if (obstacle.empty()) return 0;
  logging::warn("{}", bus::jpeg_notice(obstacle));
  return options_.jpeg_quality;
}

void SimulatorNode::run(bus::Bus& bus) {
  if (options_.lockstep) {
    run_lockstep(bus, *world_, options_.lockstep_timeout_s);
  } else {
    run_real_time(bus, *world_);
  }
}

}  // namespace markservo::simulator
