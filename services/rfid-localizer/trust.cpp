#include "services/rfid-localizer/trust.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

namespace markservo::rfid_localizer {

bool Trust::follow(Agreement agreement, double surprise, double sigma) {
  if (agreement == Agreement::kAgrees) {
    constexpr double kMostRelief = -2.0;
    const double doubtful = (surprise - parameters_.usual_surprise) / parameters_.surprise_scale;
    doubt_ = std::max(doubt_ + std::clamp(doubtful, kMostRelief, 1.0), 0.0);
    agreements_ = std::min(agreements_ + 1, parameters_.confirmations);
    if (agreements_ == parameters_.confirmations && sigma <= parameters_.largest_sigma) placed_once_ = true;
  }
  if (agreement == Agreement::kContradicts) doubt_ += 1.0;
  return doubt_ >= parameters_.lost;
}

bool Trust::follow_silence(double probability) {
  if (probability > parameters_.usual_silence) return false;
  constexpr double kLeast = 1e-300;
  const double doubtful = std::log(std::max(probability, kLeast)) / std::log(parameters_.unlikely);
  doubt_ += std::min(doubtful, 1.0);
  return doubt_ >= parameters_.lost;
}

void Trust::lose(const std::string& why) {
  agreements_ = 0;
  doubt_ = 0.0;
  why_lost_ = why;
}

Placement Trust::placement(double sigma, double since_round) const {
  const bool good = agreements_ == parameters_.confirmations && doubt_ < parameters_.suspect &&
                    sigma <= parameters_.largest_sigma && since_round <= parameters_.silence;
  if (good) return Placement::kLocalised;
  return placed_once_ ? Placement::kLost : Placement::kSearching;
}

std::string Trust::reason(double sigma, double since_round) const {
  if (placement(sigma, since_round) == Placement::kLocalised) return {};
  if (since_round > parameters_.silence) {
    return fmt::format("no round of the RFID reader for {:.1f} s", since_round);
  }
  if (agreements_ == 0) {
    return why_lost_.empty() ? "no tag of the map was read yet" : why_lost_ + "; no tag of the map was read since";
  }
  if (agreements_ < parameters_.confirmations) {
    return fmt::format("{} of {} rounds confirm the place", agreements_, parameters_.confirmations);
  }
  if (doubt_ >= parameters_.suspect) return "the reads contradict the pose";
  return fmt::format("position known to {:.2f} m only; allowed: {:.2f} m", sigma, parameters_.largest_sigma);
}

}  // namespace markservo::rfid_localizer
