#pragma once

#include "services/rfid-localizer/motion.hpp"

namespace markservo::rfid_localizer {

// Three ways to move, switched between at any time (interacting multiple models; Blom and Bar-Shalom, IEEE Trans.
// Autom. Control 33(8), 1988): standing, cruising with next to no acceleration, and manoeuvring.
struct FreeMotionParameters {
  double cruise = 0.02;        // m/s per sqrt(s), white acceleration
  double manoeuvre = 0.5;      // m/s per sqrt(s): reaches 0.4 m/s in half a second
  double setting_off = 0.1;    // per second, from standing or cruising to manoeuvring
  double settling = 1.5;       // per second, from manoeuvring to each of the others
  double speed_sigma = 0.5;    // m/s, each axis, before any read: a robot's usual speeds
  double delay_walk = 0.0003;  // s per sqrt(s)
};

// State (x, y, velocity x, velocity y, delay) of the antenna's middle, moved by inertia. The heading is that of the
// velocity: a robot that moves forward.
class FreeMotionModel final : public Motion {
 public:
  FreeMotionModel(const Eigen::Vector2d& p_RF, const FreeMotionParameters& parameters);

  // Keeps one hypothesis of each way to move, in their order.
  Mixture start(const Place& place, const DelayPrior& delay) const override;
  void predict(Mixture& mixture, std::int64_t from, std::int64_t to) const override;
  AntennaView antenna(const Hypothesis& hypothesis, std::int64_t middle, std::int64_t round) const override;
  bool learns_delay() const override { return false; }
  int angle() const override { return -1; }
  void clean(Mixture& mixture) const override;
  PoseEstimate pose(const Mixture& mixture, std::int64_t utime) const override;

 private:
  Eigen::Vector2d p_RF_;
  FreeMotionParameters parameters_;
};

}  // namespace markservo::rfid_localizer
