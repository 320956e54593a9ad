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
};

// One piece of the way. Mean on an arc; covariance by the arc's Jacobian.
void advance(Hypothesis& hypothesis, const WheelMotion& motion, const WheelNoise& noise);

}  // namespace markservo::rfid_localizer
