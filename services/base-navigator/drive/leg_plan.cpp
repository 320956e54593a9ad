#include "services/base-navigator/drive/leg_plan.hpp"

#include <algorithm>
#include <cmath>

namespace markservo::base_navigator {
namespace {

using geometry::PlanePose;
using geometry::wrapped;

Leg straight_to(const PlanePose& X_WR, const PlanePose& X_WV, bool to_goal) {
  const double bearing = std::atan2(X_WV.y - X_WR.y, X_WV.x - X_WR.x);
  return {{X_WV.x, X_WV.y, bearing}, Direction::kForward, to_goal};
}

Leg correction(const LegParameters& parameters, const PlanePose& X_GR, const PlanePose& X_WG, double room_behind,
               double room_ahead) {
  // Away along the goal's axis, where there is more room; the next leg comes back and is beside it no more.
  const double away = parameters.back_off + std::abs(X_GR.x);
  const bool back = room_behind >= away || room_behind >= room_ahead;
  const double room = std::min(away, back ? room_behind : room_ahead);
  if (std::abs(X_GR.y) <= parameters.beside_within || room < parameters.back_off_least) {
    return {X_WG, X_GR.x <= 0.0 ? Direction::kForward : Direction::kBackward, true};
  }
  const double along = back ? -room : room;
  const PlanePose X_GV{X_GR.x + along, 0.0, 0.0};
  return {X_WG * X_GV, back ? Direction::kBackward : Direction::kForward, false};
}

}  // namespace

LegPlan plan_leg(const LegParameters& parameters, const PlanePose& X_WR, const PlanePose& X_WG, bool docking,
                 bool staged, double room_behind, double room_ahead) {
  const PlanePose X_GR = X_WG.inverse() * X_WR;
  LegPlan plan;
  plan.there = X_GR.distance() <= parameters.at_goal;
  if (plan.there) return plan;
  const bool looks_along = std::abs(wrapped(X_GR.heading)) <= parameters.heading_within;
  if (X_GR.distance() <= parameters.near && looks_along) {
    plan.leg = correction(parameters, X_GR, X_WG, room_behind, room_ahead);
    return plan;
  }
  const double off_axis = std::atan2(std::abs(X_GR.y), std::abs(X_GR.x));
  const bool along_axis = off_axis <= parameters.heading_within;
  if (X_GR.x > 0.0 && along_axis && looks_along && X_GR.distance() <= parameters.reverse_within) {
    plan.leg = {X_WG, Direction::kBackward, true};
  } else if (X_GR.x < 0.0 && along_axis) {
    plan.leg = {X_WG, Direction::kForward, true};
  } else if (docking && !staged) {
    plan.leg = straight_to(X_WR, X_WG * PlanePose{-parameters.staging_distance, 0.0, 0.0}, false);
  } else {
    plan.leg = straight_to(X_WR, X_WG, true);
  }
  return plan;
}

}  // namespace markservo::base_navigator
