#pragma once

#include <cstdint>
#include <string>

#include "tests/system/fault_campaign/bench.hpp"
#include "tests/system/fault_campaign/world_clock.hpp"

namespace markservo::campaign {

// The work in which faults strike: what a person would ask the robot to do, until it is in a phase.
class RobotWork {
 public:
  explicit RobotWork(Bench& bench);

  // The simulator's arguments that the phase needs.
  static std::string simulator_arguments(const std::string& phase);

  // Releases the robot, starts the task, and listens until the phase has begun. False, with the reason in problem(),
  // where it did not come to that.
  bool bring_to(const std::string& phase);
  const std::string& problem() const { return problem_; }

  // The task has come to an end by its own word, or there is none.
  bool task_ended() const;

  // How long nothing of the arm, the base and the task's state has changed since the watch began: s of the world's
  // time.
  void watch_for_standstill();
  double stands_for();
  // The world's time as it passed since the work began: s.
  double world_seconds();

 private:
  bool release();
  bool start(bool drive, bool carry);
  bool in_phase(const std::string& phase) const;
  bool fail(const std::string& problem);

  Bench& bench_;
  std::int64_t session_;
  std::int64_t next_id_ = 1;
  bool started_ = false;
  SimTruth seen_arm_{};
  SimBaseTruth seen_base_{};
  int seen_state_ = -1;
  std::string problem_;
  WorldClock clock_;
};

inline constexpr const char* kTarget = "red_book";

}  // namespace markservo::campaign
