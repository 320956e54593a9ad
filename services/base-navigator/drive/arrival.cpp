#include "services/base-navigator/drive/arrival.hpp"

#include <fmt/format.h>

#include <cmath>

#include "common/time/seconds_between.hpp"

namespace markservo::base_navigator {
namespace {

using geometry::degrees;
using geometry::PlanePose;

bool within(const PoseError& error, double distance, double heading) {
  return error.distance <= distance && std::abs(error.heading) <= heading;
}

bool stands(const ArrivalParameters& parameters, const Command& measured) {
  return std::abs(measured.speed) <= parameters.standing_speed &&
         std::abs(measured.turn_rate) <= parameters.standing_turn_rate;
}

}  // namespace

PoseError error_of(const PlanePose& X_WR, const PlanePose& X_WG) {
  const PlanePose X_RG = X_WR.inverse() * X_WG;
  return {X_RG.distance(), X_RG.heading};
}

bool coarsely_there(const ArrivalParameters& parameters, const PoseError& error) {
  return within(error, parameters.coarse_position, parameters.coarse_heading);
}

bool has_left(const ArrivalParameters& parameters, const PoseError& error) {
  return !within(error, parameters.leave_position, parameters.leave_heading);
}

Arrival::Verdict Arrival::judge(const ArrivalParameters& parameters, const Situation& situation,
                                const PoseError& error) {
  if (!stands(parameters, situation.measured)) {
    standing_since_ = 0;
    return Verdict::kWaits;
  }
  if (standing_since_ == 0) standing_since_ = situation.utime;
  const double stood = seconds_between(standing_since_, situation.utime);
  if (stood < parameters.settle_time) return Verdict::kWaits;
  const bool waited = stood >= parameters.settle_time_max;
  const bool sharp = situation.position_sigma <= 0.5 * parameters.position;
  if (within(error, parameters.position, parameters.heading)) {
    return sharp || waited ? Verdict::kArrived : Verdict::kWaits;
  }
  // What is only just outside may prove to be inside while the pose gets better.
  if (!waited && (!sharp || coarsely_there(parameters, error))) return Verdict::kWaits;
  return judge_outside(parameters, error);
}

Arrival::Verdict Arrival::judge_outside(const ArrivalParameters& parameters, const PoseError& error) {
  standing_since_ = 0;
  if (corrections_ < parameters.corrections) {
    ++corrections_;
    return Verdict::kCorrects;
  }
  if (coarsely_there(parameters, error)) return Verdict::kWillDo;
  why_given_up_ = fmt::format("gave up after {} corrections: {:.3f} m and {:.1f} degrees off; allowed {:.3f} m, {:.1f}",
                              corrections_, error.distance, degrees(error.heading), parameters.coarse_position,
                              degrees(parameters.coarse_heading));
  return Verdict::kGivesUp;
}

}  // namespace markservo::base_navigator
