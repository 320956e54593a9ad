#pragma once

// The simulated arm on the bus: JOINT_STATE out; JOINT_COMMAND, as its owner hands it over, in.

#include <markservo/channels.hpp>

#include "common/bus/bus.hpp"
#include "services/simulator/faults/sensor_faults.hpp"
#include "services/simulator/world/simulation.hpp"

namespace markservo::simulator {

class ArmNode {
 public:
  // `simulation` outlives this.
  ArmNode(bus::Bus& bus, Simulation& simulation);

  // Gives a command to the arm. Throws std::invalid_argument for a command to another kind of arm.
  CommandAnswer on_command(const JointCommand& message);
  // Drops a command that was not obeyed, with the reason, where its writer should know.
  void drop_unless_obeyed(const JointCommand& message, const CommandAnswer& answer) const;

  void publish();

 private:
  Simulation* simulation_;
  bus::Publisher<JointState> states_;
  SensorFaults faults_;
};

}  // namespace markservo::simulator
