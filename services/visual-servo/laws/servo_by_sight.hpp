#pragma once

// A SERVO goal: from anywhere to the grip point, by sight of both marks. Resolved-rate motion brings the grip point to
// an entry posture just before the goal; one move in fixed directions enters it; at rest, several frames are averaged,
// and what is left is corrected by backing off and entering again. Servos are not told apart: good ones need one entry.

#include "services/visual-servo/arm/settling.hpp"
#include "services/visual-servo/laws/convergence.hpp"
#include "services/visual-servo/laws/one_sided_approach.hpp"
#include "services/visual-servo/laws/resolved_rate.hpp"
#include "services/visual-servo/laws/servo_law.hpp"
#include "services/visual-servo/sight/kinematic_bias.hpp"

namespace markservo::visual_servo {

struct SightParameters {
  ResolvedRateParameters rate;
  SettlingParameters settling;
  OneSidedParameters one_sided;
  KinematicBiasParameters bias;
  ConvergenceParameters convergence;
  double joint_margin = 0.0087;  // rad (0.5 degrees) from limits and from the stretched arm, for goals
  double entry_radius = 0.003;   // m from the entry posture, where the entry begins
  double entry_unseen =
      0.010;            // m of motion that the picture before the entry may still lack: a fast hand is seen worse
  double near = 0.005;  // m; a goal that begins nearer than this is judged before anything moves
  double far = 0.015;   // m; errors larger than this are approached anew rather than corrected
};

struct SightState {
  enum class Phase { kStart, kApproach, kBackOff, kEnter, kSettle, kConverged };
  Phase phase = Phase::kStart;
  KinematicBias bias;
  JointVector directions = JointVector::Ones();
  JointVector final = JointVector::Zero();  // rad, where backing off and entering lead to
  SettledWindow window;
  int corrections = 0;
};

class ServoBySight : public ServoLaw {
 public:
  ServoBySight(robot::ArmDescription arm, const SightParameters& parameters);
  LawAnswer step(const LawInput& input, LawState& state) const override;

 private:
  robot::ArmDescription arm_;
  SightParameters parameters_;
};

}  // namespace markservo::visual_servo
