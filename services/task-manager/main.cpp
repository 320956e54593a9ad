#include "common/bus/service.hpp"
#include "services/task-manager/task_manager_node.hpp"

int main(int argc, char** argv) {
  markservo::task_manager::TaskManagerNode node;
  return markservo::bus::run_service(
      {"task-manager",
       "Takes an object: TASK_COMMAND, TARGET_POSE, SERVO_STATUS, JOINT_STATE, STOP_STATE, BASE_STATUS to "
       "SERVO_GOAL, BASE_GOAL, TASK_STATE"},
      node, argc, argv);
}
