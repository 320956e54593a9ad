#include "tests/experiments/localisation/read_information.hpp"

#include <array>
#include <cmath>
#include <stdexcept>
#include <string>

namespace markservo::experiments {
namespace {

// Gauss-Legendre with five points on [-1/2, 1/2]: the edge moves by up to ten of its softnesses during a round.
constexpr std::array<double, 5> kNodes{-0.4530899229693320, -0.2692346550528415, 0.0, 0.2692346550528415,
                                       0.4530899229693320};
constexpr std::array<double, 5> kWeights{0.1184634425280945, 0.2393143352496832, 0.2844444444444444, 0.2393143352496832,
                                         0.1184634425280945};
// Beyond this many softnesses outside the radius a tag is read once in 10^7 rounds and tells nothing.
constexpr double kReach = 16.0;
// A tag that is read (or not) as surely as this tells nothing, and its quotient would be 0/0.
constexpr double kLeastVariance = 1e-12;

void check(const ReaderModel& reader) {
  const auto require = [](bool holds, const std::string& what, double value, const std::string& allowed) {
    if (holds) return;
    throw std::invalid_argument("ReaderModel: " + what + " is " + std::to_string(value) + "; allowed: " + allowed);
  };
  require(reader.reading_radius > 0.0, "reading_radius", reader.reading_radius, "above 0 m");
  require(reader.edge_softness > 0.0, "edge_softness", reader.edge_softness, "above 0 m");
  require(reader.read_probability > 0.0 && reader.read_probability <= 1.0, "read_probability", reader.read_probability,
          "above 0, at most 1");
  require(reader.round_time >= 0.0, "round_time", reader.round_time, "0 s or more");
}

}  // namespace

ReadInformation read_information(const ReaderModel& reader, const TruePath& path, double middle) {
  check(reader);
  struct Antenna {
    Eigen::Vector2d p_WF;
    Eigen::Vector2d lever;  // its derivative by the heading at the round's middle
    double weight = 0.0;
  };
  const PathPoint centre = path.at(middle);
  std::array<Antenna, kNodes.size()> antennas;
  for (std::size_t i = 0; i < kNodes.size(); ++i) {
    const Eigen::Vector2d p_WF = path.at(middle + kNodes[i] * reader.round_time).at(reader.p_RF);
    const Eigen::Vector2d from_robot = p_WF - centre.p_WR;
    antennas[i] = {p_WF, {-from_robot.y(), from_robot.x()}, kWeights[i]};
  }
  const Eigen::Vector2d p_WF = centre.at(reader.p_RF);
  const Eigen::Vector2d arm = p_WF - centre.p_WR;
  const Eigen::Vector2d velocity = centre.speed * Eigen::Vector2d(std::cos(centre.heading), std::sin(centre.heading)) +
                                   centre.turn_rate * Eigen::Vector2d(-arm.y(), arm.x());
  const double way = (antennas.back().p_WF - antennas.front().p_WF).norm();
  const double reach = reader.reading_radius + kReach * reader.edge_softness + way;

  ReadInformation information = ReadInformation::Zero();
  for (const Eigen::Vector2d& tag : reader.tags) {
    if ((tag - p_WF).squaredNorm() > reach * reach) continue;
    double p = 0.0;
    Eigen::Vector4d gradient = Eigen::Vector4d::Zero();
    for (const Antenna& antenna : antennas) {
      const Eigen::Vector2d from_tag = antenna.p_WF - tag;
      const double distance = from_tag.norm();
      const double inside = 1.0 / (1.0 + std::exp((distance - reader.reading_radius) / reader.edge_softness));
      p += antenna.weight * reader.read_probability * inside;
      if (distance <= 0.0) continue;  // the top of the footprint is flat
      const double slope = -reader.read_probability * inside * (1.0 - inside) / reader.edge_softness;
      const Eigen::Vector2d by_position = slope / distance * from_tag;
      gradient.head<2>() += antenna.weight * by_position;
      gradient[2] += antenna.weight * by_position.dot(antenna.lever);
    }
    gradient[3] = -gradient.head<2>().dot(velocity);
    const double variance = p * (1.0 - p);
    if (variance > kLeastVariance) information += gradient * gradient.transpose() / variance;
  }
  return information;
}

}  // namespace markservo::experiments
