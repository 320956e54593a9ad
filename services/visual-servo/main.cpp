// visual-servo: brings the arm where SERVO_GOAL says, by sight of the marks or by posture.

#include "common/bus/service.hpp"
#include "services/visual-servo/visual_servo_node.hpp"

int main(int argc, char** argv) {
  markservo::visual_servo::VisualServoNode node;
  return markservo::bus::run_service(
      {"visual-servo", "SERVO_GOAL, TARGET_POSE, JOINT_STATE and STOP_STATE in; JOINT_COMMAND and SERVO_STATUS out"},
      node, argc, argv);
}
