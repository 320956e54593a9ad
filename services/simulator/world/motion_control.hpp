#pragma once

// Whether arm and base may move: one STOP that latches both, and for each the gate that its commands pass. Times in us,
// of the simulation.

#include <cstdint>
#include <string>

#include "common/motion/command_gate.hpp"
#include "common/motion/stop_latch.hpp"

namespace markservo::simulator {

class MotionControl {
 public:
  // `session`: of all that the simulation tells.
  explicit MotionControl(std::int64_t session) : arm_("JOINT_COMMAND", session), base_("BASE_COMMAND", session) {}

  // A STOP or its reset, of arm and base. Released, they move by commands that answer a frame exposed after this, or an
  // odometry told after this.
  motion::StopHeard hear_stop(const motion::StopRequestStamp& request, std::int64_t now);
  // Latches the stop by the simulation itself.
  void latch(const std::string& reason, std::int64_t now) { latch_.latch(reason, now); }
  const motion::StopLatch& stop() const { return latch_; }

  // What becomes of a command that comes now. Two writers of it latch.
  motion::CommandVerdict hear_arm(const motion::OfferedCommand& command, std::int64_t now);
  motion::CommandVerdict hear_base(const motion::OfferedCommand& command, std::int64_t now);

  // True if the arm has had no command that it obeys for too long.
  bool arm_is_silent(std::int64_t now) const { return arm_.silent(now); }

  // What commands answer: a frame was exposed, an odometry was told.
  void observe_frame(std::int64_t now) { frame_utime_ = now; }
  void observe_odometry(std::int64_t now) { odometry_utime_ = now; }

 private:
  motion::CommandVerdict hear(motion::CommandGate& gate, const motion::OfferedCommand& command, std::int64_t now);

  motion::StopLatch latch_{"the simulated world"};
  motion::CommandGate arm_;
  motion::CommandGate base_;
  std::int64_t frame_utime_ = 0;     // of the newest frame; 0 before the first
  std::int64_t odometry_utime_ = 0;  // of the newest odometry; likewise
};

}  // namespace markservo::simulator
