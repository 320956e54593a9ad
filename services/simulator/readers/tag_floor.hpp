#pragma once

// The tags that are really in the floor: the map's, less the missing ones, each off its surveyed place.

#include <Eigen/Core>
#include <cstdint>
#include <string>
#include <unordered_set>
#include <vector>

#include "common/geometry/point_grid.hpp"
#include "common/robot/robot_description.hpp"

namespace markservo::simulator {

struct TagFloorParameters {
  double missing = 0.0;       // share of the map's tags that are not there or dead, [0, 1]
  double survey_error = 0.0;  // m, standard deviation of true less mapped position, each axis
};

class TagFloor {
 public:
  // The floor of `map`. Throws std::invalid_argument for parameters out of range.
  TagFloor(const robot::TagField& map, const TagFloorParameters& parameters, std::uint64_t seed);

  // All tags that are there, at their true places in W, in the map's order.
  const std::vector<robot::FloorTag>& tags() const { return tags_; }

  // Which of tags() are within `radius` (m, 0 or more) of `p_W`, in rising order.
  std::vector<int> near(const Eigen::Vector2d& p_W, double radius) const;

  // True if the map has that uid, there or missing.
  bool maps(const std::string& uid) const { return mapped_.count(uid) != 0; }

 private:
  std::vector<robot::FloorTag> tags_;
  std::unordered_set<std::string> mapped_;
  geometry::PointGrid places_;  // of tags_
};

}  // namespace markservo::simulator
