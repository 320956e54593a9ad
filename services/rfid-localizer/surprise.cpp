#include "services/rfid-localizer/surprise.hpp"

#include <algorithm>
#include <cmath>

namespace markservo::rfid_localizer {

double surprise(const std::vector<double>& chances, double log_evidence, double least) {
  double expected = 0.0;  // of the logarithm
  double variance = 0.0;
  for (const double chance : chances) {
    const double p = std::clamp(chance, least, 1.0 - least);
    const double q = 1.0 - p;
    expected += p * std::log(p) + q * std::log(q);
    variance += p * q * std::pow(std::log(p / q), 2);
  }
  constexpr double kOneTag = 1.0;  // nats^2: where all is all but certain one outcome in a thousand is no wonder yet
  return (expected - log_evidence) / std::sqrt(variance + kOneTag);
}

}  // namespace markservo::rfid_localizer
