#pragma once

// The floor's tags as surveyed, quick to find by uid and by place.

#include <Eigen/Core>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "common/geometry/point_grid.hpp"
#include "common/robot/robot_description.hpp"

namespace markservo::rfid_localizer {

class TagMap {
 public:
  // `reach` (m, above 0) sets the size of the cells that near() looks through. Throws std::invalid_argument if the
  // field is empty.
  TagMap(const robot::TagField& field, double reach);

  std::size_t size() const { return places_.size(); }
  const Eigen::Vector2d& position(int tag) const { return places_[tag]; }  // m in W

  // The tag's number, or nothing for a uid that is not in the map.
  std::optional<int> find(const std::string& uid) const;

  // The tags within `radius` (m) of `p_W`, in ascending order, into `tags`.
  void near(const Eigen::Vector2d& p_W, double radius, std::vector<int>& tags) const {
    places_.near(p_W, radius, tags);
  }

 private:
  geometry::PointGrid places_;
  std::unordered_map<std::string, int> by_uid_;
};

}  // namespace markservo::rfid_localizer
