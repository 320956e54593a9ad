#pragma once

// An experiment's hold on a simulated world: it resets the world, gives goals and commands, and follows it frame by
// frame. In lockstep (simulator --lockstep --wait-for ...,SIM_CONTROL) the world goes on only when the experiment says
// so, and what it does happens at a known frame; in real time it follows.

#include <sys/types.h>

#include <chrono>
#include <cstdint>
#include <functional>
#include <map>
#include <markservo/JointState.hpp>
#include <markservo/MarkDetection.hpp>
#include <markservo/ServoGoal.hpp>
#include <markservo/ServoStatus.hpp>
#include <markservo/SimControl.hpp>
#include <markservo/SimTruth.hpp>
#include <markservo/StopRequest.hpp>
#include <markservo/StopState.hpp>
#include <markservo/TaskCommand.hpp>
#include <markservo/TaskState.hpp>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "common/bus/bus.hpp"
#include "common/motion/command_sender.hpp"

namespace markservo::experiments {

// The world does not answer, or a run is invalid: no result may be drawn from it.
class RigFailure : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

class Rig {
 public:
  using Settings = std::vector<std::pair<std::string, double>>;

  enum class Pace { kLockstep, kRealTime };

  Rig(const std::string& lcm_url, const std::string& robot, Pace pace = Pace::kLockstep);

  // Waits until the service `name` of process `pid` says that it has started: no message passes it by from then on.
  void wait_for_service(const std::string& name, pid_t pid);
  // Waits until the simulator speaks.
  void wait_for_world();
  // SIM_CONTROL RESET; throws RigFailure if the simulator refuses a setting. The arm is latched afterwards.
  void reset(std::int64_t seed, const Settings& settings);
  // STOP reset, until every device that has spoken says it is unlatched. In lockstep once `answered` (if given) holds
  // for the present frame, so that the services learn of it between the same two frames in every run.
  void unlatch(const std::function<bool()>& answered = {});

  // Waits for the next frame. In lockstep lets the world go on by one frame, once `answered` (if given) holds for this
  // one.
  void step(const std::function<bool()>& answered = {});

  // Waits for the MARK_DETECTION of the present frame.
  void wait_for_detection();

  // Sends a command until TASK_STATE echoes it, stepping meanwhile.
  void command(TaskCommand message);
  // A goal of the experiment's own (no task-manager runs); every call is a new goal, repeated at 5 Hz by step().
  void give_goal(const ServoGoal& goal);

  const SimTruth& truth() const { return truth_; }
  const ServoStatus& servo() const { return servo_; }
  const TaskState& task() const { return task_; }
  const MarkDetection& detection() const { return detection_; }
  std::int64_t goal_id() const { return goal_.goal_id; }
  // For channels of the experiment's own.
  bus::Bus& bus() { return bus_; }

  bool servo_answered() const {
    return servo_.frame_session == truth_.frame_session && servo_.frame_seq == truth_.frame_seq;
  }
  bool task_answered() const {
    return task_.frame_session == truth_.frame_session && task_.frame_seq == truth_.frame_seq;
  }
  bool detection_answered() const {
    return detection_.frame_session == truth_.frame_session && detection_.frame_seq == truth_.frame_seq;
  }

 private:
  // Polls until `done`, calling `nudge` every 0.3 s; throws RigFailure after `kPatience`.
  void wait(const char* what, const std::function<bool()>& done, const std::function<void()>& nudge = {});
  void send_step();

  Pace pace_;
  bus::Bus bus_;
  bus::Publisher<SimControl> controls_;
  bus::Publisher<StopRequest> stops_;
  bus::Publisher<TaskCommand> commands_;
  bus::Publisher<ServoGoal> goals_;
  SimTruth truth_{};
  ServoStatus servo_{};
  TaskState task_{};
  std::map<std::string, StopState> stops_heard_;  // by device
  motion::CommandSender sender_{{"arm"}};         // every simulated robot has one
  MarkDetection detection_{};
  ServoGoal goal_{};
  std::set<pid_t> started_;  // processes whose service has said that it runs
  std::int64_t next_id_ = 1;
  std::int64_t goal_sent_utime_ = 0;
};

}  // namespace markservo::experiments
