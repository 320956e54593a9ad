#pragma once

// Experiments' hold on the simulated world: SIM_TRUTH out, which also echoes what they asked for; SIM_CONTROL, as its
// owner hands it over, in.

#include <cstdint>
#include <markservo/SimControl.hpp>
#include <markservo/SimTruth.hpp>
#include <string>

#include "common/bus/bus.hpp"
#include "common/motion/command_inbox.hpp"
#include "services/simulator/node/run_state.hpp"
#include "services/simulator/world/simulation.hpp"

namespace markservo::simulator {

class ControlNode {
 public:
  // `simulation` and `run` outlive this.
  ControlNode(bus::Bus& bus, Simulation& simulation, RunState& run);

  // Executes a RESET or SET once and echoes it.
  void on_control(const SimControl& message);

  // What is true at the frame exposed now.
  void tell_truth(std::int64_t frame_session, std::int64_t frame_seq);

 private:
  void execute(const SimControl& message);
  void publish();

  Simulation* simulation_;
  RunState* run_;
  bus::Publisher<SimTruth> truths_;
  motion::CommandInbox inbox_{"SIM_CONTROL", "the simulated world"};
  std::string error_;  // of the newest command
  SimTruth truth_{};   // of the newest frame
};

}  // namespace markservo::simulator
