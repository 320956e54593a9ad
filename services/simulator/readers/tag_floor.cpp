#include "services/simulator/readers/tag_floor.hpp"

#include <stdexcept>

#include "services/simulator/random.hpp"

namespace markservo::simulator {
namespace {

constexpr double kCell = 0.25;  // m: a few tags each, a few cells per reading footprint

}  // namespace

TagFloor::TagFloor(const robot::TagField& map, const TagFloorParameters& parameters, std::uint64_t seed)
    : places_(kCell) {
  if (!(parameters.missing >= 0.0 && parameters.missing <= 1.0)) {
    throw std::invalid_argument("TagFloor: missing is " + std::to_string(parameters.missing) + "; allowed: 0 to 1");
  }
  if (!(parameters.survey_error >= 0.0 && parameters.survey_error <= 1.0)) {
    throw std::invalid_argument("TagFloor: survey_error is " + std::to_string(parameters.survey_error) +
                                " m; allowed: 0 to 1 m");
  }
  for (std::size_t i = 0; i < map.tags.size(); ++i) {
    mapped_.insert(map.tags[i].uid);
    RandomBits bits(seed_for(seed, streams::kTagPlace, i));
    if (bits.uniform() < parameters.missing) continue;
    robot::FloorTag tag = map.tags[i];
    tag.p_W.x() += parameters.survey_error * bits.gaussian();
    tag.p_W.y() += parameters.survey_error * bits.gaussian();
    places_.add(tag.p_W);
    tags_.push_back(std::move(tag));
  }
}

std::vector<int> TagFloor::near(const Eigen::Vector2d& p_W, double radius) const {
  std::vector<int> found;
  places_.near(p_W, radius, found);
  return found;
}

}  // namespace markservo::simulator
