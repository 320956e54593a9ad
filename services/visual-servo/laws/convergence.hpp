#pragma once

// When a hand at rest is near enough to its goal: finer than asked at first, so that the goal is met with something in
// hand; and averaged for longer where a few frames cannot tell.

namespace markservo::visual_servo {

struct ConvergenceParameters {
  double tolerance = 0.001;        // m, when the goal states none
  double fine_tolerance = 0.0007;  // m, aimed at while corrections help: what judging by 4 frames can tell
  double fine_part = 0.4;          // of the goal's tolerance is aimed at, when that is more
  int fine_corrections = 4;        // after so many the goal's tolerance will do
  double doubt = 0.0003;           // m above what is aimed at: four frames cannot tell, so more are averaged
  double sure = 0.0002;            // m above what is aimed at, from where their average tells: 3 sigma of eight frames
  double leave_factor = 2.0;       // x tolerance: a converged goal is left behind when the error exceeds this
  double leave_margin = 0.0008;    // m above the tolerance, at least
};

// The tolerance that holds for a goal that states `stated` (m, 0: none), m.
double tolerance_of(const ConvergenceParameters& parameters, double stated);

enum class Verdict { kConverged, kInDoubt, kOff };

// Judges an averaged error (m) after so many corrections. `many_frames`: the average is of as many frames as are taken
// in doubt.
Verdict judge(const ConvergenceParameters& parameters, double tolerance, int corrections, double error,
              bool many_frames);

// Whether a converged goal stays so with this error (m).
bool stays_converged(const ConvergenceParameters& parameters, double tolerance, double error);

}  // namespace markservo::visual_servo
