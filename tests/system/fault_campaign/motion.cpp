#include "tests/system/fault_campaign/motion.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "tests/system/fault_campaign/words.hpp"

namespace markservo::campaign {
namespace {

constexpr double kShortest_s = 0.02;  // an exposure may be told twice at one time

}  // namespace

double farthest_joint(const std::vector<double>& a, const std::vector<double>& b) {
  if (a.size() != b.size()) return 0.0;
  double farthest = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) farthest = std::max(farthest, std::abs(a[i] - b[i]));
  return farthest;
}

double way_between(const SimBaseTruth& a, const SimBaseTruth& b) {
  return std::hypot(b.pose.x - a.pose.x, b.pose.y - a.pose.y);
}

double turn_between(const SimBaseTruth& a, const SimBaseTruth& b) {
  return std::abs(std::remainder(b.pose.heading - a.pose.heading, 2.0 * std::acos(-1.0)));
}

std::string base_moved(const SimBaseTruth& a, const SimBaseTruth& b, double most_m, double most_rad) {
  const double way = way_between(a, b);
  const double turn = turn_between(a, b);
  return way <= most_m && turn <= most_rad ? "" : text("moved %.4f m and %.4f rad", way, turn);
}

bool ShaftsAround::distance(std::int64_t t, std::size_t i, double angle, double& distance) const {
  const auto after = std::upper_bound(truth_.begin(), truth_.end(), t,
                                      [](std::int64_t time, const auto& truth) { return time < truth.t; });
  if (after == truth_.begin() || after == truth_.end()) return false;
  const SimTruth& last = std::prev(after)->message;
  const SimTruth& next = after->message;
  if (!same_world(last, next) || i >= last.shaft.size() || i >= next.shaft.size()) return false;
  const double low = std::min(last.shaft[i], next.shaft[i]);
  const double high = std::max(last.shaft[i], next.shaft[i]);
  distance = angle < low ? low - angle : angle > high ? angle - high : 0.0;
  return true;
}

bool same_world(const SimTruth& last, const SimTruth& next) {
  // A RESET begins the world anew; a SET leaves the bodies where they are, and the first height tells them apart.
  const bool touched_again = last.arm_touched && !next.arm_touched;
  return last.session == next.session && next.frame_seq >= last.frame_seq && !touched_again;
}

std::vector<ArmStep> arm_steps(const Timeline& timeline) {
  std::vector<ArmStep> steps;
  const Heard<SimTruth>* last = nullptr;
  for (const auto& truth : timeline.truth) {
    if (last != nullptr && !same_world(last->message, truth.message)) last = nullptr;
    if (last != nullptr) {
      const double seconds = truth.world - last->world;
      const double way = farthest_joint(last->message.shaft, truth.message.shaft);
      if (seconds < kShortest_s && way == 0.0) continue;
      steps.push_back({last, &truth, way, way / std::max(seconds, kShortest_s)});
    }
    last = &truth;
  }
  return steps;
}

std::vector<BaseStep> base_steps(const Timeline& timeline) {
  std::vector<BaseStep> steps;
  const Heard<SimBaseTruth>* last = nullptr;
  for (const auto& truth : timeline.base_truth) {
    if (last == nullptr || last->message.session != truth.message.session) {
      last = &truth;
      continue;
    }
    const double seconds = truth.world - last->world;
    if (seconds < kBaseStep_s) continue;
    const double way = way_between(last->message, truth.message);
    steps.push_back({last, &truth, way, way / seconds, turn_between(last->message, truth.message) / seconds});
    last = &truth;
  }
  return steps;
}

}  // namespace markservo::campaign
