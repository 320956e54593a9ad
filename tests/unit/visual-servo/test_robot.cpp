#include "tests/unit/visual-servo/test_robot.hpp"

#include <string>

namespace markservo::visual_servo::test {

robot::RobotDescription the_robot() {
  return robot::load_robot_description(std::string(MARKSERVO_SOURCE_DIR) + "/config/robot.yaml");
}

Goal grip_goal(std::int64_t utime, std::int64_t id) {
  Goal goal;
  goal.utime = utime;
  goal.session = 5;
  goal.id = id;
  goal.kind = GoalKind::kServo;
  goal.target = "red_book";
  goal.p_TG_C = kGripFromTarget;
  goal.gripper_opening = 0.05;
  goal.gripper_force = 10.0;
  return goal;
}

void repeat_goal(const ServoStateMachine& machine, State& state, std::int64_t utime) {
  Goal again = *state.followed.goal();
  again.utime = utime;
  machine.observe(again, state);
}

}  // namespace markservo::visual_servo::test
