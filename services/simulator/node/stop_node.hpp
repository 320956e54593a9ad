#pragma once

// The stop of the simulated robot on the bus: STOP_STATE of arm and base out; STOP, as its owner hands it over, in.

#include <markservo/channels.hpp>

#include "common/bus/bus.hpp"
#include "common/bus/repeat_timer.hpp"
#include "services/simulator/node/run_state.hpp"
#include "services/simulator/world/simulation.hpp"

namespace markservo::simulator {

class StopNode {
 public:
  // `simulation` and `run` outlive this.
  StopNode(bus::Bus& bus, Simulation& simulation, const RunState& run);

  // Obeys and echoes.
  void on_stop(const StopRequest& message);

  void publish();
  // Publishes when it is time again.
  void repeat();
  // Two writers of its commands latch the world by themselves: tells of it once.
  void tell_of_a_latch();

 private:
  // After a reset the world's time is ahead until the second that it leapt by has passed; then all is told.
  bool is_ahead() const { return run_->world_is_new && simulation_->timing() == Timing::kRealTime; }

  Simulation* simulation_;
  const RunState* run_;
  bus::Publisher<StopState> states_;
  bus::RepeatTimer timer_{bus::kStateRepeat_us};
  bool told_latched_ = true;
};

}  // namespace markservo::simulator
