#include "services/rfid-localizer/read_model.hpp"

#include <cmath>
#include <stdexcept>
#include <string>

namespace markservo::rfid_localizer {

ReadModel::ReadModel(double radius, double softness) : radius_(radius), softness_(softness) {
  if (!(radius > 0.0) || !(softness > 0.0)) {
    throw std::invalid_argument("reading radius " + std::to_string(radius) + " m, softness " +
                                std::to_string(softness) + " m; allowed: above 0");
  }
  constexpr double kTail = 8.0;  // softnesses beyond the radius, where less than one read in 2,000 is left
  reach_ = radius + kTail * softness;
  bins_per_m2_ = static_cast<double>(kBins) / (reach_ * reach_);
  for (std::size_t bin = 0; bin <= kBins; ++bin) {
    const double distance = std::sqrt(static_cast<double>(bin) / bins_per_m2_);
    table_[bin] = 1.0 / (1.0 + std::exp((distance - radius) / softness));
  }
}

}  // namespace markservo::rfid_localizer
