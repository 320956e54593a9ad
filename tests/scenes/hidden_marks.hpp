#pragma once

// How well the real detector and locator measure marks that something nearer hides in part, against the truth.

#include <cstdint>
#include <functional>
#include <vector>

#include "common/robot/robot_description.hpp"
#include "services/target-locator/mark_locator.hpp"

namespace markservo::scenes {

enum class Hiding {
  kNothing,
  kPartly,  // by an edge or a finger from any side, 20 to 60 mm before the mark
};

struct HidingParameters {
  double share_min = 0.05;  // of the mark, in the view that shows less of it
  double share_max = 0.50;
  double gap_min = 0.02;  // m, the hiding thing before the mark
  double gap_max = 0.06;
};

// One draw and what became of it.
struct HiddenMarkDraw {
  unsigned seed = 0;
  double hidden_left = 0.0;   // share of the mark's area
  double hidden_right = 0.0;  // share
  bool finger = false;        // hidden by a narrow thing that ends within the mark
  double edge_deg = 0.0;      // the direction it comes from, 0: from the right, 90: from above
  bool detected = false;      // in both views
  target_locator::Location location;
  Eigen::Vector3d error = Eigen::Vector3d::Zero();  // m; valid when located
  double mahalanobis_2 = 0.0;                       // of the error by the published covariance

  bool located() const { return location.status == target_locator::Status::kLocated; }
};

// Draws of marks of known size of the robot at 220 to 300 mm, slanted by up to 18 degrees, and `advance` after each.
std::vector<HiddenMarkDraw> draw_hidden_marks(const robot::RobotDescription& robot, Hiding hiding, int count,
                                              unsigned seed, const HidingParameters& parameters,
                                              const std::function<void()>& advance = {});

// Over the located of some draws.
struct Consistency {
  int drawn = 0;
  int detected = 0;
  int located = 0;
  double within = 0.0;              // share whose squared Mahalanobis distance is below kChiSquare99
  double mean_nees = 0.0;           // 3 degrees of freedom
  double median_sigma = 0.0;        // m, of sqrt(trace / 3)
  double median_worst_sigma = 0.0;  // m, of the root of the covariance's largest eigenvalue
  double median_error = 0.0;        // m
  double p95_error = 0.0;           // m
};
inline constexpr double kChiSquare99 = 11.34;  // 3 degrees of freedom

Consistency consistency_of(const std::vector<HiddenMarkDraw>& draws);

}  // namespace markservo::scenes
