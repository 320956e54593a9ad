#pragma once

// Moves a hypothesis on by what the wheels said.

#include "services/rfid-localizer/hypothesis.hpp"
#include "services/rfid-localizer/wheel_history.hpp"

namespace markservo::rfid_localizer {

// How far wheels may be believed.
struct WheelNoise {
  double drift = 0.045;        // rad per sqrt(m): robot.yaml's 2 degrees, times the margin for slip
  double turn_error = 0.03;    // rad per sqrt(rad) of turning: track and tyres
  double scale_walk = 0.01;    // per sqrt(m): load and floor change the wheels' effective radius
  double creep = 0.0003;       // m per sqrt(s): what no encoder sees
  double delay_walk = 0.0003;  // s per sqrt(s)
  double track = 0.32;         // m
  double pivot_wander = 0.0;   // m per sqrt(rad), each axis, of the place while turning: robot.yaml's
};

// What each of robot.yaml's numbers adds to the covariance over one piece of the way, per unit of its square.
struct NoiseShares {
  StateCovariance drift = StateCovariance::Zero();         // 1 / (rad^2 / m)
  StateCovariance pivot_wander = StateCovariance::Zero();  // 1 / (m^2 / rad)
  double turning = 0.0;                                    // rad^2, of the heading by the turning itself: of no number
};

// The Jacobian of the motion by the state, at `state`.
StateCovariance motion_jacobian(const StateVector& state, const WheelMotion& motion);

// At `state`.
NoiseShares noise_shares(const StateVector& state, const WheelMotion& motion, const WheelNoise& noise);

// One piece of the way. Mean on an arc; covariance by the arc's Jacobian.
void advance(Hypothesis& hypothesis, const WheelMotion& motion, const WheelNoise& noise);

}  // namespace markservo::rfid_localizer
