#include "services/base-navigator/kinematics/odometry_track.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace markservo::base_navigator {

using geometry::PlanePose;

std::string OdometryTrack::add(const OdometryParameters& parameters, const OdometrySample& sample) {
  if (first_utime_ == 0 || sample.utime < first_utime_) first_utime_ = sample.utime;
  problem_ = accept(parameters, sample);
  return problem_;
}

void OdometryTrack::forget() {
  history_.clear();
  first_utime_ = 0;
  problem_.clear();
}

std::string OdometryTrack::accept(const OdometryParameters& parameters, const OdometrySample& sample) {
  if (history_.empty()) {
    begin(sample);
    return "";
  }
  const Entry& last = history_.back();
  const double seconds = seconds_between(last.utime, sample.utime);
  if (seconds <= 0.0) {
    return fmt::format("utime is {:.3f} s before or at the newest; allowed: growing", -seconds);
  }
  if (seconds > parameters.gap) {
    begin(sample);
    return "";
  }
  const double left = sample.left - last.left;
  const double right = sample.right - last.right;
  const double allowed = 2.0 * parameters.wheel_speed * seconds + parameters.jump;
  if (const double way = std::max(std::abs(left), std::abs(right)); way > allowed) {
    begin(sample);
    return fmt::format("a wheel went {:.3f} m in {:.3f} s; allowed: {:.3f} m", way, seconds, allowed);
  }
  const double way = 0.5 * (left + right);
  const double turn = (right - left) / parameters.track;
  const PlanePose X_OH = last.X_OR * PlanePose{0.0, 0.0, 0.5 * turn};  // H: R with the heading of half-way
  const PlanePose X_OR = X_OH * PlanePose{geometry::chord(way, turn), 0.0, 0.5 * turn};
  history_.push_back({sample.utime, sample.left, sample.right, X_OR});
  while (seconds_between(history_.front().utime, sample.utime) > parameters.kept) history_.pop_front();
  measure_speed(parameters);
  return "";
}

void OdometryTrack::begin(const OdometrySample& sample) {
  history_.clear();
  history_.push_back({sample.utime, sample.left, sample.right, PlanePose()});
  ++epoch_;
  speed_ = 0.0;
  turn_rate_ = 0.0;
}

void OdometryTrack::measure_speed(const OdometryParameters& parameters) {
  const Entry& newest = history_.back();
  const auto first = std::find_if(history_.begin(), history_.end() - 2, [&](const Entry& entry) {
    return seconds_between(entry.utime, newest.utime) <= parameters.speed_window + 1e-6;
  });
  const double seconds = seconds_between(first->utime, newest.utime);
  const double left = newest.left - first->left;
  const double right = newest.right - first->right;
  speed_ = 0.5 * (left + right) / seconds;
  turn_rate_ = (right - left) / parameters.track / seconds;
}

double OdometryTrack::step() const {
  return history_.size() < 2 ? 0.0 : seconds_between(history_[history_.size() - 2].utime, history_.back().utime);
}

std::optional<PlanePose> OdometryTrack::at(std::int64_t utime, double beyond) const {
  if (history_.empty()) return std::nullopt;
  if (seconds_between(history_.back().utime, utime) >= 0.0) {
    return seconds_between(history_.back().utime, utime) <= beyond ? std::optional(history_.back().X_OR) : std::nullopt;
  }
  if (seconds_between(utime, history_.front().utime) >= 0.0) {
    return seconds_between(utime, history_.front().utime) <= beyond ? std::optional(history_.front().X_OR)
                                                                    : std::nullopt;
  }
  const auto after =
      std::find_if(history_.begin(), history_.end(), [utime](const Entry& e) { return e.utime > utime; });
  const auto before = after - 1;
  const double part = seconds_between(before->utime, utime) / seconds_between(before->utime, after->utime);
  const PlanePose d = before->X_OR.inverse() * after->X_OR;
  return before->X_OR * PlanePose{part * d.x, part * d.y, part * d.heading};
}

}  // namespace markservo::base_navigator
