// mark-detector: STEREO_FRAME in, MARK_DETECTION out; LEARN_REQUEST in, LEARN_RESULT out.

#include "common/bus/service.hpp"
#include "services/mark-detector/mark_detector_node.hpp"

int main(int argc, char** argv) {
  markservo::mark_detector::MarkDetectorNode node;
  return markservo::bus::run_service(
      {"mark-detector",
       "Finds the robot's colour marks in image pairs: reads STEREO_FRAME, writes MARK_DETECTION; learns "
       "colours: reads LEARN_REQUEST, writes LEARN_RESULT"},
      node, argc, argv);
}
