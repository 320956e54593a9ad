// mark-detector: STEREO_FRAME in, MARK_DETECTION out.

#include "common/bus/service.hpp"
#include "services/mark-detector/mark_detector_node.hpp"

int main(int argc, char** argv) {
  markservo::mark_detector::MarkDetectorNode node;
  return markservo::bus::run_service(
      {"mark-detector", "Finds the robot's colour marks in image pairs: reads STEREO_FRAME, writes MARK_DETECTION"},
      node, argc, argv);
}
