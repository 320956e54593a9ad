#pragma once

// Whether the base stands when what it drives by falls silent, by the simulator's truth.

#include <cstdint>
#include <markservo/SimBaseTruth.hpp>
#include <nlohmann/json.hpp>
#include <optional>

#include "common/bus/bus.hpp"

namespace markservo::experiments {

// When the base must have stopped after the last message of a channel.
struct SilenceLimits {
  double age = 0.3;           // s of the world's time, from which it brakes
  double braking = 0.8;       // m/s^2
  double turn_braking = 2.0;  // rad/s^2
  double margin = 0.2;        // s: a command answers an odometry, and is obeyed a moment later
};

// One channel. Times are the world's, us, as the messages tell them.
class SilenceWatch {
 public:
  explicit SilenceWatch(const SilenceLimits& limits) : limits_(limits) {}

  // A message of `utime`; one that is no newer than the newest does not count.
  void message(std::int64_t utime);
  void observe(const SimBaseTruth& truth);

  double longest() const { return longest_; }  // s, silence that began while the base drove
  double moved() const { return moved_; }      // m, when the base had to stand
  double turned() const { return turned_; }    // rad, likewise

 private:
  void begin_anew(std::int64_t utime);

  SilenceLimits limits_;
  std::optional<SimBaseTruth> last_;
  std::optional<std::int64_t> newest_;  // us
  std::optional<double> rest_age_;      // s, silence after which it must stand; absent: not yet old
  bool drove_ = false;                  // when the newest message came
  double longest_ = 0.0;
  double moved_ = 0.0;
  double turned_ = 0.0;
};

// ROBOT_POSE, BASE_COMMAND and BASE_GOAL.
class StaleDriveWatch {
 public:
  explicit StaleDriveWatch(bus::Bus& bus);
  const SilenceWatch& pose() const { return pose_; }
  const SilenceWatch& command() const { return command_; }
  const SilenceWatch& goal() const { return goal_; }

 private:
  SilenceWatch pose_, command_, goal_;
};

// For report.json: longest_s, moved_m and turned_rad of each channel.
nlohmann::json report_of(const StaleDriveWatch& watch);

}  // namespace markservo::experiments
