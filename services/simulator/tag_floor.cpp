#include "services/simulator/tag_floor.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "services/simulator/random.hpp"

namespace markservo::simulator {
namespace {

constexpr std::uint64_t kTagStream = 0x61;
constexpr double kCell = 0.25;  // m: a few tags each, a few cells per reading footprint

std::int64_t cell_index(double coordinate) {
  return static_cast<std::int64_t>(std::floor(coordinate / kCell));
}

std::int64_t cell_key(std::int64_t column, std::int64_t row) {
  constexpr std::int64_t kColumns = std::int64_t{1} << 31;
  return row * kColumns + column;
}

}  // namespace

TagFloor::TagFloor(const robot::TagField& map, const TagFloorParameters& parameters, std::uint64_t seed) {
  if (!(parameters.missing >= 0.0 && parameters.missing <= 1.0)) {
    throw std::invalid_argument("TagFloor: missing is " + std::to_string(parameters.missing) + "; allowed: 0 to 1");
  }
  if (!(parameters.survey_error >= 0.0 && parameters.survey_error <= 1.0)) {
    throw std::invalid_argument("TagFloor: survey_error is " + std::to_string(parameters.survey_error) +
                                " m; allowed: 0 to 1 m");
  }
  for (std::size_t i = 0; i < map.tags.size(); ++i) {
    mapped_.insert(map.tags[i].uid);
    RandomBits bits(seed_for(seed, kTagStream, i));
    if (bits.uniform() < parameters.missing) continue;
    robot::FloorTag tag = map.tags[i];
    tag.p_W.x() += parameters.survey_error * bits.gaussian();
    tag.p_W.y() += parameters.survey_error * bits.gaussian();
    cells_[cell_key(cell_index(tag.p_W.x()), cell_index(tag.p_W.y()))].push_back(tags_.size());
    tags_.push_back(std::move(tag));
  }
}

std::vector<std::size_t> TagFloor::near(const Eigen::Vector2d& p_W, double radius) const {
  std::vector<std::size_t> found;
  for (std::int64_t row = cell_index(p_W.y() - radius); row <= cell_index(p_W.y() + radius); ++row) {
    for (std::int64_t column = cell_index(p_W.x() - radius); column <= cell_index(p_W.x() + radius); ++column) {
      const auto cell = cells_.find(cell_key(column, row));
      if (cell == cells_.end()) continue;
      for (const std::size_t i : cell->second) {
        if ((tags_[i].p_W - p_W).squaredNorm() <= radius * radius) found.push_back(i);
      }
    }
  }
  std::sort(found.begin(), found.end());
  return found;
}

}  // namespace markservo::simulator
