#pragma once

// The running simulation without the bus: the world, its time, its frames, and which commands move arm and base when.
// Simulated time begins at a given epoch, never goes back, and advances only by step() and reset().

#include <cstdint>
#include <optional>
#include <string>

#include "common/motion/command_path.hpp"
#include "common/robot/robot_description.hpp"
#include "services/simulator/arm/delayed_commands.hpp"
#include "services/simulator/cameras/exposures.hpp"
#include "services/simulator/cameras/image_effects.hpp"
#include "services/simulator/scene/scene.hpp"
#include "services/simulator/settings/settings.hpp"
#include "services/simulator/world/mobile_base.hpp"
#include "services/simulator/world/motion_control.hpp"
#include "services/simulator/world/simulated_time.hpp"
#include "services/simulator/world/world.hpp"

namespace markservo::simulator {

// Where time begins in lockstep, so that the same seed gives the same run: 2020-09-13 12:26:40 UTC.
inline constexpr std::int64_t kEpoch_us = 1'600'000'000'000'000;

enum class Timing {
  kRealTime,  // commands take effect servo.delay_s after they came
  kLockstep,  // commands take effect servo.delay_frames after the frame that they answer
};

// What became of a command.
struct CommandAnswer {
  motion::CommandVerdict verdict = motion::CommandVerdict::kLatched;
  std::optional<std::size_t> joint;  // whose command leads the shaft or jumps: of these two verdicts only
};

class Simulation {
 public:
  // `session` is what all that it tells carries; `epoch`: us, when its time begins. Throws ConfigurationError if the
  // world cannot be built.
  Simulation(robot::RobotDescription robot, Scene scene, const Settings& start, std::uint64_t seed, Timing timing,
             std::int64_t session, std::int64_t epoch = kEpoch_us);

  // Builds the world anew from the start's settings with `changes` on top; arm and base are latched. The clock goes on
  // by a second, so that whatever was said before is stale. Throws ConfigurationError and changes nothing if it cannot
  // be.
  void reset(std::uint64_t seed, const Assignments& changes);

  // Changes settings that show at once. Throws ConfigurationError and changes nothing if one cannot be.
  void set(const Assignments& changes);

  // A STOP or its reset, of arm and base together. Latched, the arm stays where it is, the grip keeps its force, and
  // the base brakes. Released, they move when a command answers a frame exposed after this, or an odometry told after
  // this.
  motion::StopHeard hear_stop(const motion::StopRequestStamp& request);
  std::string why_stale(const motion::StopRequestStamp& request) const { return latch().why_stale(request, utime()); }
  const motion::StopLatch& latch() const { return control_.stop(); }

  // A command that comes now, in answer to frame `frame_seq`. Two writers of it latch all.
  CommandAnswer command(const motion::OfferedCommand& offered, std::int64_t frame_seq, const ArmCommand& command);
  // The same for the base: wanted speed (m/s) and turn rate (rad/s) in answer to an odometry. kOtherMover from a robot
  // without a base.
  motion::CommandVerdict command_base(const motion::OfferedCommand& offered, double speed, double turn_rate);

  // Lets kTimeStep pass. Throws std::runtime_error if the physics diverged.
  void step();
  std::int64_t utime() const { return time_.utime(); }            // us
  std::int64_t elapsed_us() const { return time_.elapsed_us(); }  // since the epoch
  Timing timing() const { return timing_; }

  bool has_base() const { return base_.has_value(); }
  // What the base's devices tell that has become due since the last call; nothing from a robot without a base.
  MobileBaseOutputs take_due();
  // What is true about the base. Throws std::logic_error if the robot has none.
  MobileBaseTruth base_truth() const;
  // The newest odometry was told now.
  void observe_odometry() { control_.observe_odometry(utime()); }

  // True when the next frame's exposure is now.
  bool frame_due() const { return exposures_.due(time_.steps()); }
  // Exposes the frame `seq` now. An exposure may be repeated under a new seq while time stands still.
  void expose(std::int64_t seq);
  // True if the exposed frame is one of the lost ones.
  bool dropped() const { return exposures_.lost(seed_, settings_.frames.drop_rate); }
  // Of the exposed frame.
  NoiseSeeds noise() const;
  ImageEffects effects() const { return image_effects(settings_.image, settings_.light); }

  World& world() { return world_; }
  const World& world() const { return world_; }
  const robot::RobotDescription& robot() const { return robot_; }
  const Settings& settings() const { return settings_; }
  std::uint64_t seed() const { return seed_; }

 private:
  void freeze();
  void freeze_arm();
  // The frame or the time (us) at which a command in answer to frame `frame_seq` takes effect.
  std::int64_t effect_of(std::int64_t frame_seq) const;
  std::optional<MobileBase> new_base(const Settings& settings, std::uint64_t seed, std::int64_t epoch) const;

  robot::RobotDescription robot_;
  Scene scene_;
  Settings start_;
  Settings settings_;
  std::uint64_t seed_;
  Timing timing_;
  World world_;
  std::optional<MobileBase> base_;
  SimulatedTime time_;
  MotionControl control_;
  motion::CommandPath path_;
  DelayedCommands delayed_;
  Exposures exposures_;
};

}  // namespace markservo::simulator
