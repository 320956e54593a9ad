// base-navigator: drives the base where BASE_GOAL says, by the localiser's pose, and stops for what the sonars see.

#include "common/bus/service.hpp"
#include "services/base-navigator/base_navigator_node.hpp"

int main(int argc, char** argv) {
  markservo::base_navigator::BaseNavigatorNode node;
  return markservo::bus::run_service({"base-navigator",
                                      "BASE_GOAL, ROBOT_POSE, SONAR_SCAN, WHEEL_ODOMETRY and STOP_STATE in; "
                                      "BASE_STATUS and BASE_COMMAND out"},
                                     node, argc, argv);
}
