#pragma once

#include <optional>

#include "services/rfid-localizer/motion.hpp"
#include "services/rfid-localizer/wheel_history.hpp"
#include "services/rfid-localizer/wheel_prediction.hpp"

namespace markservo::rfid_localizer {

struct WheelMotionParameters {
  WheelNoise noise;
  double scale_sigma = 0.02;   // of the wheels' effective radius, before any read
  int headings = 16;           // hypotheses of an unknown heading: 22.5 degrees apart an arc is still straight enough
  double least_weight = 1e-6;  // two silent rounds in a row over a tag (0.05 each) must not end the right one
  std::size_t most = 200;  // hypotheses, after a round: reads that fit no place must not cost more than a round's time
  double merge_distance = 0.7;  // standard deviations: what such neighbours say together is still a Gaussian
};

struct HeadingPrior {
  double mean = 0.0;   // rad in W
  double sigma = 0.0;  // rad
};

// State (x, y, heading, wheel scale error, delay), moved by what `history` recorded.
class WheelMotionModel final : public Motion {
 public:
  // `history` must outlive this.
  WheelMotionModel(const WheelHistory& history, const Eigen::Vector2d& p_RF, const WheelMotionParameters& parameters);

  // From now on the wheels are believed so far.
  void set_noise(const WheelNoise& noise) { parameters_.noise = noise; }

  // The next start() uses it; nothing: any heading.
  void set_heading(const std::optional<HeadingPrior>& heading) { heading_ = heading; }

  Mixture start(const Place& place, const DelayPrior& delay) const override;
  void predict(Mixture& mixture, std::int64_t from, std::int64_t to) const override;
  AntennaView antenna(const Hypothesis& hypothesis, std::int64_t middle, std::int64_t round) const override;
  bool learns_delay() const override { return true; }
  int angle() const override { return kHeading; }
  void clean(Mixture& mixture) const override;
  PoseEstimate pose(const Mixture& mixture, std::int64_t utime) const override;

 private:
  const WheelHistory& history_;
  Eigen::Vector2d p_RF_;
  WheelMotionParameters parameters_;
  std::optional<HeadingPrior> heading_;
};

}  // namespace markservo::rfid_localizer
