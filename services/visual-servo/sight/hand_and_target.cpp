#include "services/visual-servo/sight/hand_and_target.hpp"

#include <fmt/format.h>

#include "services/visual-servo/sight/in_flight.hpp"
#include "services/visual-servo/sight/mark_lookup.hpp"

namespace markservo::visual_servo {
namespace {

// Why the hand's mark is not where a hand can be; empty when it is.
std::string why_another_thing(const robot::ArmDescription& arm, const JointVector& q_exposure, const MarkSample& hand,
                              double allowed) {
  const double mismatch = kinematic_bias(arm, q_exposure, hand.p_C).norm();
  if (!(mismatch > allowed)) return "";
  return fmt::format("mark {}: {:.3f} m from where the joints say it is, allowed {:.3f} m", hand.name, mismatch,
                     allowed);
}

}  // namespace

Sighting HandAndTarget::observe(const HandAndTargetParameters& parameters, const robot::ArmDescription& arm,
                                const PoseSample& pose, const JointVector& q_exposure, const std::string& hand,
                                const std::string& target) {
  Sighting sighting;
  const MarkSample* hand_mark = find(pose, hand);
  const MarkSample* target_mark = find(pose, target);
  sighting.lost = why_lost(target_mark, target);
  if (!sighting.lost.empty()) return sighting;
  target_.observe(parameters.target, target_mark->p_C, target_mark->covariance);
  sighting.lost = why_lost(hand_mark, hand);
  if (!sighting.lost.empty()) return sighting;
  sighting.lost = why_another_thing(arm, q_exposure, *hand_mark, parameters.hand_mismatch);
  if (!sighting.lost.empty()) return sighting;
  sighting.utime = pose.utime;
  sighting.q_exposure = q_exposure;
  sighting.p_CM = hand_mark->p_C;
  sighting.hand_covariance = hand_mark->covariance;
  sighting.p_CT = target_.position();
  sighting.target_covariance = target_.covariance();
  return sighting;
}

}  // namespace markservo::visual_servo
