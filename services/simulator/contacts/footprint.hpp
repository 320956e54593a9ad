#pragma once

// Rectangles on the floor: how far apart a robot's outline and the things around it are.

#include <Eigen/Core>

namespace markservo::simulator {

struct Footprint {
  Eigen::Vector2d centre = Eigen::Vector2d::Zero();  // m
  Eigen::Vector2d half = Eigen::Vector2d::Zero();    // m, half the edges, 0 or more
  double yaw = 0.0;                                  // rad, of the first edge, counter-clockwise
};

// m, between the nearest points of two rectangles; 0 if they touch or overlap.
double distance(const Footprint& a, const Footprint& b);

}  // namespace markservo::simulator
