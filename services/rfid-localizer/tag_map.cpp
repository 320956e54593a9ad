#include "services/rfid-localizer/tag_map.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace markservo::rfid_localizer {

TagMap::TagMap(const robot::TagField& field, double reach) : cell_size_(reach) {
  if (field.tags.empty())
    throw std::invalid_argument("tag field '" + field.name + "' is empty; allowed: 1 tag or more");
  for (const robot::FloorTag& tag : field.tags) {
    const int number = static_cast<int>(positions_.size());
    positions_.push_back(tag.p_W);
    by_uid_.emplace(tag.uid, number);
    by_cell_[cell(cell_index(tag.p_W.x()), cell_index(tag.p_W.y()))].push_back(number);
  }
}

int TagMap::cell_index(double coordinate) const {
  // A robot far off any map asks for cells that hold nothing.
  constexpr double kFarthest = 1e9;
  return static_cast<int>(std::floor(std::clamp(coordinate / cell_size_, -kFarthest, kFarthest)));
}

TagMap::Cell TagMap::cell(int column, int row) {
  return static_cast<Cell>((static_cast<std::uint64_t>(static_cast<std::uint32_t>(column)) << 32) |
                           static_cast<std::uint32_t>(row));
}

std::optional<int> TagMap::find(const std::string& uid) const {
  const auto entry = by_uid_.find(uid);
  if (entry == by_uid_.end()) return std::nullopt;
  return entry->second;
}

void TagMap::near(const Eigen::Vector2d& p_W, double radius, std::vector<int>& tags) const {
  tags.clear();
  const int first_column = cell_index(p_W.x() - radius);
  const int first_row = cell_index(p_W.y() - radius);
  const int last_column = cell_index(p_W.x() + radius);
  const int last_row = cell_index(p_W.y() + radius);
  // Who does not know where it is asks for more cells than there are tags.
  const double cells = (1.0 + last_column - first_column) * (1.0 + last_row - first_row);
  if (cells > static_cast<double>(size())) {
    for (int tag = 0; tag < static_cast<int>(size()); ++tag) {
      if ((position(tag) - p_W).squaredNorm() <= radius * radius) tags.push_back(tag);
    }
    return;
  }
  for (int column = first_column; column <= last_column; ++column) {
    for (int row = first_row; row <= last_row; ++row) {
      const auto entry = by_cell_.find(cell(column, row));
      if (entry == by_cell_.end()) continue;
      for (const int tag : entry->second) {
        if ((position(tag) - p_W).squaredNorm() <= radius * radius) tags.push_back(tag);
      }
    }
  }
  std::sort(tags.begin(), tags.end());
}

}  // namespace markservo::rfid_localizer
