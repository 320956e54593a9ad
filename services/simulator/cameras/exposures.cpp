#include "services/simulator/cameras/exposures.hpp"

#include <algorithm>

#include "services/simulator/model/time_step.hpp"
#include "services/simulator/random.hpp"

namespace markservo::simulator {

Exposures::Exposures(double rate_hz, std::int64_t first_step) : schedule_(rate_hz, kTimeStep, first_step) {}

void Exposures::begin_anew(double rate_hz, std::int64_t first_step) {
  schedule_ = FrameSchedule(rate_hz, kTimeStep, first_step);
  number_ = 0;
  exposed_step_ = -1;
}

void Exposures::change_rate(double rate_hz, std::int64_t step) {
  const bool exposed = exposed_step_ >= 0;
  schedule_ = FrameSchedule(rate_hz, kTimeStep, exposed ? exposed_step_ : step);
  if (exposed) schedule_.advance();
}

void Exposures::expose(std::int64_t step, std::int64_t seq) {
  if (exposed_step_ == step) return;
  exposed_step_ = step;
  first_seq_ = seq;
  ++number_;
  schedule_.advance();
}

std::int64_t Exposures::number_of(std::int64_t seq) const {
  return number_ - std::max<std::int64_t>(0, first_seq_ - seq);
}

bool Exposures::lost(std::uint64_t seed, double drop_rate) const {
  return RandomBits(seed_for(seed, streams::kLostFrames, static_cast<std::uint64_t>(number_))).uniform() < drop_rate;
}

}  // namespace markservo::simulator
