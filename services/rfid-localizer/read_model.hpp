#pragma once

// How likely the reader reads a tag at a distance: a footprint with a soft edge.

#include <array>
#include <cstddef>

namespace markservo::rfid_localizer {

class ReadModel {
 public:
  // A tag `radius` (m) from the antenna's middle answers every other time; `softness` (m) is the scale of the logistic
  // edge. Both above 0, else std::invalid_argument.
  ReadModel(double radius, double softness);

  // The footprint's share in the read probability, from 1 well inside to 0 at reach() and beyond; `squared_distance`
  // in m^2. Off by at most 0.001 where the radius is 5 softnesses or more.
  double inside(double squared_distance) const {
    const double position = squared_distance * bins_per_m2_;
    if (position >= static_cast<double>(kBins)) return 0.0;
    const auto bin = static_cast<std::size_t>(position);
    const double share = position - static_cast<double>(bin);
    return table_[bin] + share * (table_[bin + 1] - table_[bin]);
  }

  double reach() const { return reach_; }        // m
  double softness() const { return softness_; }  // m
  double radius() const { return radius_; }      // m

 private:
  static constexpr std::size_t kBins = 2048;

  double radius_;
  double softness_;
  double reach_;
  double bins_per_m2_;
  std::array<double, kBins + 1> table_{};
};

}  // namespace markservo::rfid_localizer
