#include "services/task-operator/task_operator_node.hpp"

int main(int argc, char** argv) {
  markservo::task_operator::TaskOperatorNode node(argc > 0 ? argv[0] : "");
  const int code = markservo::bus::run_service(
      {"task-operator", "Tells the robot what to do (TASK_COMMAND, STOP) until it answers (TASK_STATE, STOP_STATE)"},
      node, argc, argv);
  return code != markservo::bus::kExitStopped ? code : node.exit_code();
}
