#include "services/simulator/world/motion_control.hpp"

namespace markservo::simulator {

motion::StopHeard MotionControl::hear_stop(const motion::StopRequestStamp& request, std::int64_t now) {
  std::string obstacle = arm_.obstacle(now);
  if (obstacle.empty()) obstacle = base_.obstacle(now);
  const motion::StopHeard heard = latch_.hear(request, now, obstacle);
  if (heard == motion::StopHeard::kReleased) {
    arm_.release(frame_utime_);
    base_.release(odometry_utime_);
  }
  return heard;
}

motion::CommandVerdict MotionControl::hear_arm(const motion::OfferedCommand& command, std::int64_t now) {
  return hear(arm_, command, now);
}

motion::CommandVerdict MotionControl::hear_base(const motion::OfferedCommand& command, std::int64_t now) {
  return hear(base_, command, now);
}

motion::CommandVerdict MotionControl::hear(motion::CommandGate& gate, const motion::OfferedCommand& command,
                                           std::int64_t now) {
  const motion::CommandVerdict verdict = gate.hear(command, now, latch_.latched());
  if (verdict == motion::CommandVerdict::kTwoWriters) latch_.latch(gate.two_writers(), now);
  return verdict;
}

}  // namespace markservo::simulator
