#include "services/visual-servo/laws/convergence.hpp"

#include <algorithm>

namespace markservo::visual_servo {
namespace {

// The error that is aimed at, m.
double fine_error(const ConvergenceParameters& parameters, double tolerance, int corrections) {
  if (corrections >= parameters.fine_corrections) return tolerance;
  return std::min(tolerance, std::max(parameters.fine_tolerance, parameters.fine_part * tolerance));
}

}  // namespace

double tolerance_of(const ConvergenceParameters& parameters, double stated) {
  return stated > 0.0 ? stated : parameters.tolerance;
}

Verdict judge(const ConvergenceParameters& parameters, double tolerance, int corrections, double error,
              bool many_frames) {
  const double fine = fine_error(parameters, tolerance, corrections);
  if (error <= fine) return Verdict::kConverged;
  if (!many_frames) return error <= fine + parameters.doubt ? Verdict::kInDoubt : Verdict::kOff;
  // What is not surely coarser than the aim is not worth a correction, where the goal allows it.
  const double allowed = std::min(tolerance, fine + parameters.sure);
  if (error <= allowed) return Verdict::kConverged;
  return Verdict::kOff;
}

bool stays_converged(const ConvergenceParameters& parameters, double tolerance, double error) {
  return error <= std::max(parameters.leave_factor * tolerance, tolerance + parameters.leave_margin);
}

}  // namespace markservo::visual_servo
