// target-locator: MARK_DETECTION in, TARGET_POSE and STEREO_MATCHES out.

#include "common/bus/service.hpp"
#include "services/target-locator/target_locator_node.hpp"

int main(int argc, char** argv) {
  markservo::target_locator::TargetLocatorNode node;
  return markservo::bus::run_service(
      {"target-locator", "Measures marks in 3D: reads MARK_DETECTION, writes TARGET_POSE and STEREO_MATCHES"}, node,
      argc, argv);
}
