#include "services/visual-servo/arm/joint_history.hpp"

#include <algorithm>
#include <cmath>

namespace markservo::visual_servo {
namespace {

constexpr std::int64_t kKept_us = 1'000'000;
constexpr std::int64_t kAhead_us = 10'000;  // one interval of joint states: what a picture may be ahead of the newest
constexpr std::int64_t kGap_us = 300'000;   // without a joint state for so long, the arm may have been moved unseen
constexpr std::int64_t kSpan_us = 30'000;   // over which a speed is told
constexpr double kMoving = 0.02;            // rad/s; slower is rounding
constexpr double kLeapFactor = 2.0;         // of the servo's own speed
constexpr double kLeapAllowance = 0.1;      // rad, for samples that share a time stamp

bool is_leap(const JointSample& from, const JointSample& to, const JointVector& max_speed) {
  const double seconds = seconds_between(from.utime, to.utime);
  const JointVector allowed = max_speed * (kLeapFactor * seconds) + JointVector::Constant(kLeapAllowance);
  return ((to.position - from.position).cwiseAbs().array() > allowed.array()).any();
}

}  // namespace

bool JointHistory::add(const JointSample& sample, const JointVector& max_speed) {
  bool anew = false;
  if (!samples_.empty()) {
    const JointSample& last = samples_.back();
    if (sample.utime <= last.utime) return false;
    anew = sample.utime > last.utime + kGap_us || is_leap(last, sample, max_speed);
    if (anew) samples_.clear();
  }
  samples_.push_back(sample);
  while (samples_.front().utime < sample.utime - kKept_us) samples_.pop_front();
  return anew;
}

JointVector JointHistory::at(std::int64_t utime) const {
  const auto after = std::lower_bound(samples_.begin(), samples_.end(), utime,
                                      [](const JointSample& sample, std::int64_t t) { return sample.utime < t; });
  if (after == samples_.begin()) return samples_.front().position;
  if (after == samples_.end()) return extrapolated(utime);
  const auto before = std::prev(after);
  const double part = seconds_between(before->utime, utime) / seconds_between(before->utime, after->utime);
  return before->position + part * (after->position - before->position);
}

JointVector JointHistory::extrapolated(std::int64_t utime) const {
  const JointSample& last = samples_.back();
  if (samples_.size() < 2) return last.position;
  const JointSample& before = samples_[samples_.size() - 2];
  const std::int64_t later = std::min(utime - last.utime, kAhead_us);
  return last.position +
         (last.position - before.position) * (seconds_between(0, later) / seconds_between(before.utime, last.utime));
}

JointVector JointHistory::speed(std::int64_t utime) const {
  return (at(utime) - at(utime - kSpan_us)) / seconds_between(0, kSpan_us);
}

JointVector JointHistory::directions(std::int64_t utime) const {
  JointVector directions = JointVector::Zero();
  for (std::int64_t t = utime; t > samples_.front().utime; t -= kSpan_us) {
    const JointVector speed_then = speed(t);
    for (int i = 0; i < robot::kNumJoints; ++i) {
      if (directions[i] == 0.0 && std::abs(speed_then[i]) > kMoving) directions[i] = speed_then[i] > 0.0 ? 1.0 : -1.0;
    }
    if ((directions.array() != 0.0).all()) break;
  }
  return directions;
}

std::optional<std::int64_t> JointHistory::near_since(const JointVector& position, double tolerance) const {
  std::optional<std::int64_t> since;
  for (auto sample = samples_.rbegin(); sample != samples_.rend(); ++sample) {
    if ((sample->position - position).cwiseAbs().maxCoeff() > tolerance) break;
    since = sample->utime;
  }
  return since;
}

}  // namespace markservo::visual_servo
