#include "common/motion/notice.hpp"

namespace markservo::motion {

std::string notice(const MoverWatch& mover, const GoalInbox& goals, double goal_age) {
  if (!mover.conflict().empty()) return mover.conflict();
  std::string second = goals.second(mover.now(), goal_age);
  return second.empty() ? mover.stranger() : second;
}

}  // namespace markservo::motion
