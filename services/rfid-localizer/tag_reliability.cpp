#include "services/rfid-localizer/tag_reliability.hpp"

#include <algorithm>

namespace markservo::rfid_localizer {
namespace {

constexpr double kWellInside = 0.9;
// Even a tag never heard may be heard, and one always heard may fail.
constexpr double kLeastProbability = 0.3;
constexpr double kMostProbability = 0.995;

}  // namespace

TagReliability::TagReliability(std::size_t tags, const TagReliabilityParameters& parameters)
    : parameters_(parameters),
      trials_(parameters.trials),
      reads_(parameters.trials * parameters.read_probability),
      gone_(tags, parameters.gone) {}

void TagReliability::learn(int tag, bool read, double inside) {
  double& gone = gone_[static_cast<std::size_t>(tag)];
  if (read) {
    gone = parameters_.gone_after_read;
  } else {
    const double silent = 1.0 - inside * read_probability();  // of a tag that is there
    gone = gone / (gone + (1.0 - gone) * silent);
  }
  if (inside < kWellInside) return;
  // A silence that a lost tag explains says nothing about the reader.
  const double share = read ? 1.0 : 1.0 - gone;
  trials_ += share;
  if (read) reads_ += 1.0;
  reads_ = std::clamp(reads_, kLeastProbability * trials_, kMostProbability * trials_);
  if (trials_ > parameters_.memory) {
    reads_ *= parameters_.memory / trials_;
    trials_ = parameters_.memory;
  }
}

}  // namespace markservo::rfid_localizer
