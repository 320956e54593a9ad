// Shows in a browser what the robot, or a log, sees and does; stops it.
//   in: all channels, or a log     out: STOP; HTTP and WebSocket

#include "services/mmi/mmi_node.hpp"

int main(int argc, char** argv) {
  markservo::mmi::MmiNode node;
  return markservo::bus::run_service(
      {"mmi", "Shows in a browser what the robot, or a log, sees and does (all channels), and stops it (STOP)"}, node,
      argc, argv);
}
