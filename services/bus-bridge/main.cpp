// Passes named channels between this host's bus and a link to another host: small messages cross, frames stay.
//   in, out: --send, --receive, SERVICE_STATUS

#include "services/bus-bridge/bus_bridge_node.hpp"

int main(int argc, char** argv) {
  markservo::bus_bridge::BusBridgeNode node;
  return markservo::bus::run_service(
      {"bus-bridge", "Passes named channels between this host's bus and the link to another host (--send, --receive)"},
      node, argc, argv);
}
