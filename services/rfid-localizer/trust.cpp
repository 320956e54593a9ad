#include "services/rfid-localizer/trust.hpp"

#include <algorithm>
#include <cstdio>

namespace markservo::rfid_localizer {

bool Trust::follow(Agreement agreement, double sigma) {
  if (agreement == Agreement::kAgrees) {
    contradictions_ = std::max(contradictions_ - 2, 0);
    agreements_ = std::min(agreements_ + 1, parameters_.confirmations);
    if (agreements_ == parameters_.confirmations && sigma <= parameters_.largest_sigma) placed_once_ = true;
  }
  if (agreement == Agreement::kContradicts) ++contradictions_;
  return contradictions_ >= parameters_.contradictions;
}

Placement Trust::placement(double sigma, double since_round) const {
  const bool good = agreements_ == parameters_.confirmations && sigma <= parameters_.largest_sigma &&
                    since_round <= parameters_.silence;
  if (good) return Placement::kLocalised;
  return placed_once_ ? Placement::kLost : Placement::kSearching;
}

std::string Trust::reason(double sigma, double since_round) const {
  char text[120];
  if (placement(sigma, since_round) == Placement::kLocalised) return {};
  if (since_round > parameters_.silence) {
    std::snprintf(text, sizeof text, "no round of the RFID reader for %.1f s", since_round);
  } else if (agreements_ == 0) {
    std::snprintf(text, sizeof text, placed_once_ ? "the reads contradict the pose" : "no tag of the map was read yet");
  } else if (agreements_ < parameters_.confirmations) {
    std::snprintf(text, sizeof text, "%d of %d rounds confirm the place", agreements_, parameters_.confirmations);
  } else {
    std::snprintf(text, sizeof text, "position known to %.2f m only; allowed: %.2f m", sigma,
                  parameters_.largest_sigma);
  }
  return text;
}

}  // namespace markservo::rfid_localizer
