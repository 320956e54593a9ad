#pragma once

// A SERVO goal: from anywhere to the grip point, by sight of both marks. Resolved-rate motion brings the grip point to
// an entry posture just before the goal; one move in fixed directions enters it; at rest, several frames are averaged,
// and what is left is corrected by backing off and entering again. Servos are not told apart: good ones need one entry.

#include <Eigen/Core>
#include <cstdint>
#include <string>

#include "services/visual-servo/arm/arm_command.hpp"
#include "services/visual-servo/arm/joint_history.hpp"
#include "services/visual-servo/arm/settling.hpp"
#include "services/visual-servo/laws/one_sided_approach.hpp"
#include "services/visual-servo/laws/resolved_rate.hpp"
#include "services/visual-servo/sight/kinematic_bias.hpp"

namespace markservo::visual_servo {

struct SightParameters {
  ResolvedRateParameters rate;
  SettlingParameters settling;
  OneSidedParameters one_sided;
  KinematicBiasParameters bias;
  double joint_margin = 0.0087;  // rad (0.5 degrees) from limits and from the stretched arm, for goals
  double entry_radius = 0.003;   // m from the entry posture, where the entry begins
  double entry_unseen =
      0.010;                 // m of motion that the picture before the entry may still lack: a fast hand is seen worse
  double near = 0.005;       // m; a goal that begins nearer than this is judged before anything moves
  double far = 0.015;        // m; errors larger than this are approached anew rather than corrected
  double tolerance = 0.001;  // m, when the goal states none
  double fine_tolerance = 0.0007;  // m, aimed at while corrections help: what judging by 4 frames can tell
  double doubt = 0.0003;           // m above what is aimed at: four frames cannot tell, so more are averaged
  double sure = 0.0001;            // m below the goal's tolerance, with which that average meets it
  double fine_part = 0.4;          // of the goal's tolerance is aimed at, when that is more
  int fine_corrections = 4;        // after so many the goal's tolerance will do
  double leave_factor = 2.0;       // x tolerance: a converged goal is left behind when the error exceeds this
  double leave_margin = 0.0008;    // m above the tolerance, at least
};

// What one frame says.
struct Sight {
  std::int64_t utime = 0;                               // us, exposure
  double seconds = 1.0 / 30.0;                          // frame interval
  JointVector q_exposure = JointVector::Zero();         // rad
  Eigen::Vector3d p_CM = Eigen::Vector3d::Zero();       // m, hand mark
  Eigen::Vector3d p_CG_goal = Eigen::Vector3d::Zero();  // m, wanted grip point
  double tolerance = 0.0;                               // m, 0: the parameters'
  double grip_speed = 0.0;                              // m/s, limit, above 0
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

struct SightAnswer {
  ArmStep step;
  bool converged = false;
  bool settled = false;
  int frames = 1;                                   // behind `error`
  Eigen::Vector3d error = Eigen::Vector3d::Zero();  // m, grip point minus goal
  std::string unreachable;                          // why; empty when it can be reached
};

// One frame.
SightAnswer servo_by_sight(const robot::ArmDescription& arm, const SightParameters& parameters, const Sight& sight,
                           const JointHistory& joints, const ArmCommand& command, SightState& state);

}  // namespace markservo::visual_servo
