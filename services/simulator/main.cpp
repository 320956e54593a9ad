// simulator: a MuJoCo world with the robot of config/robot.yaml and the books of a scene, in place of real hardware.

#include "common/bus/service.hpp"
#include "services/simulator/node/simulator_node.hpp"

int main(int argc, char** argv) {
  markservo::simulator::SimulatorNode node;
  return markservo::bus::run_service({"simulator",
                                      "A simulated robot: STEREO_FRAME, JOINT_STATE, RFID_TAG_HITS, SONAR_SCAN, "
                                      "WHEEL_ODOMETRY, STOP_STATE, SIM_TRUTH, SIM_BASE_TRUTH out; "
                                      "JOINT_COMMAND, BASE_COMMAND, STOP, SIM_CONTROL in"},
                                     node, argc, argv);
}
