#include "services/visual-servo/arm/settling.hpp"

#include <algorithm>
#include <cmath>

namespace markservo::visual_servo {

std::optional<std::int64_t> at_rest_since(const SettlingParameters& parameters, const JointHistory& joints,
                                          const JointVector& q_command, std::int64_t command_utime) {
  if (const auto arrived = joints.near_since(q_command, parameters.arrival_tolerance)) {
    return std::max(*arrived, command_utime);
  }
  const std::int64_t still_since =
      joints.near_since(joints.newest().position, parameters.arrival_tolerance).value_or(joints.newest().utime);
  const std::int64_t rested = std::max(still_since, command_utime) + std::llround(parameters.rest_time * 1e6);
  if (joints.newest().utime < rested) return std::nullopt;
  return rested;
}

void SettledWindow::forget() {
  samples_.clear();
  seen_ = 0;
  in_doubt_ = false;
}

void SettledWindow::add(const SettlingParameters& parameters, const Eigen::Vector3d& p) {
  ++seen_;
  samples_.push_back(p);
  int kept = in_doubt_ ? std::max(parameters.frames, parameters.frames_in_doubt) : parameters.frames;
  if (seen_ > parameters.patience) kept = std::max(kept, parameters.patience);
  while (size() > kept) samples_.pop_front();
}

bool SettledWindow::ready(const SettlingParameters& parameters) const {
  if (size() < parameters.frames) return false;
  if (seen_ >= parameters.patience) return true;
  const Eigen::Vector3d middle = mean();
  return std::all_of(samples_.begin(), samples_.end(),
                     [&](const Eigen::Vector3d& p) { return (p - middle).norm() <= parameters.spread; });
}

Eigen::Vector3d SettledWindow::mean() const {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const auto& sample : samples_) sum += sample;
  return samples_.empty() ? sum : Eigen::Vector3d(sum / static_cast<double>(samples_.size()));
}

}  // namespace markservo::visual_servo
