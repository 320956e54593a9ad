#pragma once

// Where along one axis of a square its centre lies, of which something may hide either side.

#include <Eigen/Core>
#include <optional>

#include "services/target-locator/hidden/hidden_sides_parameters.hpp"
#include "services/target-locator/hidden/outermost_edge.hpp"
#include "services/target-locator/hidden/plane_outlines.hpp"

namespace markservo::target_locator {

// The centre's coordinate along the axis.
struct AxisCoordinate {
  double mean = 0.0;      // m
  double variance = 0.0;  // m^2
};

class AxisEvidence {
 public:
  // `axis`: unit length; `separation`: m, how far apart along the first axis of the plane the cameras see the edge of
  // something nearer; `crossings`: of pixels by a whole side across the axis; `size`: m, of the square. Refers to
  // `parameters`.
  AxisEvidence(const PlaneOutlines& outlines, const Eigen::Vector2d& axis, double separation, double crossings,
               double size, const HiddenSidesParameters& parameters);

  // Nothing when the outlines exceed the square.
  std::optional<AxisCoordinate> centre() const;

 private:
  struct Side {
    double out = 0.0;     // m along the axis
    double likely = 0.0;  // that it is a side of the square
  };

  Side side(const PlaneOutlines& outlines, const Eigen::Vector2d& outwards) const;
  bool is_straight(const OutermostEdge& edge) const;

  double size_;
  double pixel_;
  double apart_ = 0.0;
  double edge_variance_ = 0.0;  // m^2
  const HiddenSidesParameters& parameters_;
  Side low_;
  Side high_;
};

}  // namespace markservo::target_locator
