#pragma once

#include <memory>
#include <optional>
#include <string>

#include "common/bus/service.hpp"
#include "services/simulator/cameras/cameras.hpp"
#include "services/simulator/node/simulator_options.hpp"
#include "services/simulator/node/world_node.hpp"
#include "services/simulator/scene/scene.hpp"
#include "services/simulator/settings/settings.hpp"
#include "services/simulator/world/simulation.hpp"

namespace markservo::simulator {

// The simulated robot as a service: STEREO_FRAME, JOINT_STATE, STOP_STATE and SIM_TRUTH out, and what its base says;
// JOINT_COMMAND, BASE_COMMAND, STOP and SIM_CONTROL in. Real time unless --lockstep.
class SimulatorNode : public bus::Service {
 public:
  void add_options(CLI::App& app) override { add_simulator_options(app, options_); }
  void configure(const std::string& robot_file) override;
  std::optional<int> run_alone(const std::string& robot) override;
  void start(bus::Bus& bus) override;
  void run(bus::Bus& bus) override;

 private:
  std::unique_ptr<Simulation> new_simulation(Timing timing, std::int64_t session, std::int64_t epoch) const;
  // 1 to 100, or 0: raw.
  int jpeg_quality(const bus::BusUrls& urls) const;

  SimulatorOptions options_;
  std::string robot_file_;
  robot::RobotDescription robot_;
  Scene scene_;
  Settings settings_;
  std::unique_ptr<Cameras> cameras_;
  std::unique_ptr<Simulation> simulation_;
  std::unique_ptr<WorldNode> world_;
};

}  // namespace markservo::simulator
