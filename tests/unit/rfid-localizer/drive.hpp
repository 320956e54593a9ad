#pragma once

// A localiser on the simulated base, reader and tag floor, by plain structs: no bus, no clock.

#include <functional>
#include <memory>
#include <vector>

#include "services/rfid-localizer/localizer.hpp"
#include "services/simulator/base/base_rig.hpp"

namespace markservo::rfid_localizer::test {

robot::RobotDescription the_robot();  // config/robot.yaml's

inline constexpr double kUp = 1.5707963267948966;  // rad: along W's y, the long side of the field in use

struct DriveSettings {
  robot::RobotDescription robot = the_robot();
  simulator::BaseRigParameters rig;
  LocalizerParameters localizer;  // survey_sigma is robot.yaml's
  geometry::PlanePose start{0.2, 0.0, kUp};
  std::uint64_t seed = 1;
  bool encoders = true;
};

// One estimate with what was true at its time.
struct Scored {
  double time = 0.0;  // s since the start
  Estimate estimate;
  simulator::BaseTruth truth;

  double error() const;          // m
  double heading_error() const;  // rad, 0 or more
  double sigma() const;          // m, of the position: the larger axis
  double nees() const;           // normalised error squared of (x, y, heading)
  bool localised() const { return estimate.placement == Placement::kLocalised; }
};

class Drive {
 public:
  explicit Drive(const DriveSettings& settings);

  // `speed` (m/s) and `turn_rate` (rad/s) for `time` (s).
  void go(double time, double speed, double turn_rate = 0.0);
  void stand(double time) { go(time, 0.0); }

  // The robot stands elsewhere; its counters do not notice.
  void carry_to(const geometry::PlanePose& pose);

  // Whether the localiser hears of them.
  void set_encoders(bool on) { encoders_ = on; }
  void set_reader(bool on) { reader_ = on; }
  void change_reader(const simulator::RfidReaderParameters& parameters);

  // May change or clear a round before the localiser has it.
  std::function<void(TagRound&)> tamper = [](TagRound&) {};

  Scored now() const;
  double time() const { return 1e-6 * static_cast<double>(rig_->utime() - kEpoch); }  // s
  std::int64_t utime() const { return rig_->utime(); }
  // One per odometry or, while the localiser has no wheels, per round; in order.
  const std::vector<Scored>& history() const { return history_; }
  std::vector<Scored> since(double time) const;
  Localizer& localizer() { return localizer_; }

 private:
  static constexpr std::int64_t kEpoch = 1'700'000'000'000'000;

  void hear(const simulator::BaseOutputs& due);

  DriveSettings settings_;
  std::unique_ptr<simulator::BaseRig> rig_;
  Localizer localizer_;
  bool encoders_;
  bool reader_ = true;
  std::uint64_t rigs_ = 0;
  std::int32_t left_before_ = 0, right_before_ = 0;  // ticks to add since the robot was carried
  simulator::WheelTicks last_ticks_;
  std::vector<Scored> history_;
};

double mean_error(const std::vector<Scored>& scores);   // m
double worst_error(const std::vector<Scored>& scores);  // m

// s, the longest time for which a pose was given as LOCALISED while it was off by more than `sigmas` of its own.
double longest_untruth(const std::vector<Scored>& scores, double sigmas);

}  // namespace markservo::rfid_localizer::test
