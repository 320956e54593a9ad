#pragma once

// The floor's tags as surveyed, quick to find by uid and by place.

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "common/robot/robot_description.hpp"

namespace markservo::rfid_localizer {

class TagMap {
 public:
  // `reach` (m, above 0) sets the size of the cells that near() looks through. Throws std::invalid_argument if the
  // field is empty.
  TagMap(const robot::TagField& field, double reach);

  std::size_t size() const { return positions_.size(); }
  const Eigen::Vector2d& position(int tag) const { return positions_[static_cast<std::size_t>(tag)]; }  // m in W

  // The tag's number, or nothing for a uid that is not in the map.
  std::optional<int> find(const std::string& uid) const;

  // The tags within `radius` (m) of `p_W`, in ascending order, into `tags`.
  void near(const Eigen::Vector2d& p_W, double radius, std::vector<int>& tags) const;

 private:
  using Cell = std::int64_t;
  int cell_index(double coordinate) const;
  static Cell cell(int column, int row);

  double cell_size_;
  std::vector<Eigen::Vector2d> positions_;
  std::unordered_map<std::string, int> by_uid_;
  std::unordered_map<Cell, std::vector<int>> by_cell_;
};

}  // namespace markservo::rfid_localizer
