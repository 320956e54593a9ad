#include "services/visual-servo/arm/joint_history.hpp"

#include <algorithm>
#include <cmath>

namespace markservo::visual_servo {
namespace {

constexpr std::int64_t kKept_us = 1'000'000;
constexpr std::int64_t kAhead_us = 10'000;  // one interval of joint states: what a picture may be ahead of the newest
constexpr std::int64_t kGap_us = 300'000;   // without a joint state for so long, the arm may have been moved unseen
constexpr std::int64_t kSpan_us = 30'000;   // over which a speed is told
constexpr double kLeastPlay = 0.0006;       // rad (0.03 degrees); what turns to and fro by less is rounding
constexpr double kLeapFactor = 2.0;         // of the servo's own speed
constexpr double kLeapAllowance = 0.1;      // rad, for samples that share a time stamp

bool is_leap(const JointSample& from, const JointSample& to, const JointVector& max_speed) {
  const double seconds = seconds_between(from.utime, to.utime);
  const JointVector allowed = max_speed * (kLeapFactor * seconds) + JointVector::Constant(kLeapAllowance);
  return ((to.position - from.position).cwiseAbs().array() > allowed.array()).any();
}

}  // namespace

bool JointHistory::add(const JointSample& sample, const JointVector& max_speed, double play) {
  bool anew = false;
  JointVector trailing = JointVector::Zero();
  if (!entries_.empty()) {
    const JointSample& last = newest();
    if (sample.utime <= last.utime) return false;
    anew = sample.utime > last.utime + kGap_us || is_leap(last, sample, max_speed);
    if (anew) {
      entries_.clear();
    } else {
      const JointVector turned = (sample.position - last.position) / std::max(play, kLeastPlay);
      trailing = (entries_.back().trailing + turned).cwiseMax(-1.0).cwiseMin(1.0);
    }
  }
  entries_.push_back({sample, trailing});
  while (entries_.front().sample.utime < sample.utime - kKept_us) entries_.pop_front();
  return anew;
}

JointHistory::Entries::const_iterator JointHistory::first_from(std::int64_t utime) const {
  return std::lower_bound(entries_.begin(), entries_.end(), utime,
                          [](const Entry& entry, std::int64_t t) { return entry.sample.utime < t; });
}

JointVector JointHistory::at(std::int64_t utime) const {
  const auto after = first_from(utime);
  if (after == entries_.begin()) return entries_.front().sample.position;
  if (after == entries_.end()) return extrapolated(utime);
  const JointSample& to = after->sample;
  const JointSample& from = std::prev(after)->sample;
  const double part = seconds_between(from.utime, utime) / seconds_between(from.utime, to.utime);
  return from.position + part * (to.position - from.position);
}

JointVector JointHistory::extrapolated(std::int64_t utime) const {
  const JointSample& last = newest();
  if (entries_.size() < 2) return last.position;
  const JointSample& before = entries_[entries_.size() - 2].sample;
  const std::int64_t later = std::min(utime - last.utime, kAhead_us);
  return last.position +
         (last.position - before.position) * (seconds_between(0, later) / seconds_between(before.utime, last.utime));
}

JointVector JointHistory::speed(std::int64_t utime) const {
  return (at(utime) - at(utime - kSpan_us)) / seconds_between(0, kSpan_us);
}

const JointVector& JointHistory::trailing(std::int64_t utime) const {
  const auto after = first_from(utime + 1);
  return after == entries_.begin() ? entries_.front().trailing : std::prev(after)->trailing;
}

std::optional<std::int64_t> JointHistory::near_since(const JointVector& position, double tolerance) const {
  std::optional<std::int64_t> since;
  for (auto entry = entries_.rbegin(); entry != entries_.rend(); ++entry) {
    if ((entry->sample.position - position).cwiseAbs().maxCoeff() > tolerance) break;
    since = entry->sample.utime;
  }
  return since;
}

}  // namespace markservo::visual_servo
