#pragma once

// Whether the wheels are as good as robot.yaml states, told from what the tags correct.
//
// If the prediction's noise is right, a round's correction has nothing to do with those before it. Where the noise is
// larger than predicted they go the same way: each round leaves a share of the error for the next one (Mehra, IEEE
// Trans. Autom. Control 15(2), 1970). How a little more of a number's noise would have moved the mean is followed
// through prediction and update; corrections that agree with it, summed up, are the slope of the likelihood, and how
// much they must agree for so much noise too many, given what the prediction allowed for, is known: least squares over
// all rounds tell which number has to grow, and to what.

#include <Eigen/Core>
#include <array>

#include "common/geometry/degrees.hpp"
#include "services/rfid-localizer/hypothesis.hpp"
#include "services/rfid-localizer/wheel_prediction.hpp"

namespace markservo::rfid_localizer {

struct WheelJudgeParameters {
  double slip_margin = 1.3;  // that WheelNoise::drift has on robot.yaml's number; what fits has it too
  // How much a number is worth that was not told by rounds of a prediction that used it, in draws of the noise: what is
  // stated before the first round, and what fitted when the prediction was still told much less.
  double worth = 3.0;
  double drift_unit = geometry::radians(1.0);  // rad per sqrt(m), of such a draw at the least
  double wander_unit = 0.01;                   // m per sqrt(rad), likewise
  double certain = 3.0;                        // standard deviations above what is stated: then it is wrong
  double least_wander = 0.005;                 // m per sqrt(rad): with nothing stated, less is lost among the tags
  // The rounds were judged wrongly, and count little, where what fits has grown to so many times the square that they
  // were judged with on the average.
  double anew = 2.0;
  double fresh = 1.0;          // draws between two such steps: what was seen once is no proof of another
  double growth = 4.0;         // of a square, at once: a filter that is told far too little is no good judge
  double most_surprise = 4.0;  // standard deviations that a round counts: a robot that is pushed is no wheel's fault
  double memory = 500.0;       // draws that count, an hour of driving: floors and loads change
  // Standard deviations of an estimate that is one place and one direction, from which on it is judged, and by what
  // factor they may grow until it is not.
  double known_place = 0.06;   // m
  double known_heading = 0.2;  // rad
  double no_longer = 3.0;
  double most_drift = geometry::radians(60.0);  // rad per sqrt(m): robot.yaml's most
  double most_wander = 0.5;                     // m per sqrt(rad): likewise
};

// One of robot.yaml's numbers, in its unit there, but for rad.
struct JudgedNumber {
  double stated = 0.0;
  double fits = 0.0;       // what the rounds so far say; as stated where they say little
  bool too_small = false;  // by more than chance and the margin explain
};

struct WheelJudgement {
  JudgedNumber drift;         // rad per sqrt(m)
  JudgedNumber pivot_wander;  // m per sqrt(rad)
};

class WheelJudge {
 public:
  WheelJudge(const WheelNoise& stated, const WheelJudgeParameters& parameters);

  // What the prediction is to use: what is stated, or what fits where that is more and certain.
  const WheelNoise& believed() const { return believed_; }
  WheelJudgement judgement() const;

  // Whether the estimate is known well enough to judge by: else moved() has nothing to do.
  bool following() const { return following_; }
  // The estimate began anew: its covariance owes nothing to the wheels.
  void restart();
  // A piece of the way by which believed() predicted, from `state` on.
  void moved(const StateVector& state, const WheelMotion& motion);
  // A round took the estimate from `before` to `after`; `H` is the antenna's place by the state.
  void matched(const Hypothesis& before, const Hypothesis& after, const Eigen::Matrix<double, 2, 5>& H);

 private:
  static constexpr int kDrift = 0;
  static constexpr int kWander = 1;
  static constexpr int kUsed = 2;

  // Squares are those of robot.yaml's numbers: rad^2/m of the drift, m^2/rad of the wander.

  // The state's covariance by the errors that a noise has left: of drift and wander by one unit of the square.
  using Source = StateCovariance;
  // By one unit of a number's square.
  struct Slope {
    StateVector mean = StateVector::Zero();  // how the estimate's mean, the state, changes
    // What the errors of each source, in its unit, have in common with that change.
    std::array<StateCovariance, 3> common{StateCovariance::Zero(), StateCovariance::Zero(), StateCovariance::Zero()};
  };

  // Whether an estimate known so well (m, rad) is judged.
  bool follow(double place_sigma, double heading_sigma);
  // Least squares of what the rounds say, and what of it to believe.
  void solve();
  // What is known of a number counts as at most so many draws of the noise.
  void limit(int number, double draws);
  Eigen::Vector2d unconstrained() const;
  double least_square(int number) const;  // of what counts as a draw
  // What the errors so far still change is held for or against no number.
  void forget_errors();

  WheelNoise stated_;
  WheelJudgeParameters parameters_;
  WheelNoise believed_;
  std::array<Source, 3> sources_;  // drift, wander, and what the prediction allowed for
  std::array<Slope, 2> slopes_;
  Eigen::Matrix2d information_;                      // on the squares: one over the product of two
  Eigen::Vector2d evidence_;                         // information times the squares: one over a square
  Eigen::Vector2d fits_;                             // squares
  Eigen::Vector2d fresh_ = Eigen::Vector2d::Zero();  // the information's diagonal, of rounds since the last step
  Eigen::Vector2d judged_with_;  // squares that the prediction used, on the average of the information
  std::array<bool, 2> too_small_{};
  bool following_ = false;
};

}  // namespace markservo::rfid_localizer
