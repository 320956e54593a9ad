#include "services/simulator/readers/sonar_model.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "services/simulator/random.hpp"

namespace markservo::simulator {

std::vector<Ray> SonarModel::rays() const {
  std::vector<Ray> rays;
  for (int sonar = 0; sonar < ring_.number; ++sonar) {
    const geometry::PlanePose X_RS = ring_.pose(sonar);
    const Eigen::Vector3d origin(X_RS.x, X_RS.y, ring_.height);
    for (int i = 0; i < kRaysPerBeam; ++i) {
      const double direction = X_RS.heading + ring_.beam_width * (static_cast<double>(i) / (kRaysPerBeam - 1) - 0.5);
      rays.push_back({origin, {std::cos(direction), std::sin(direction), 0.0}});
    }
  }
  return rays;
}

SonarReading SonarModel::listen(const std::vector<std::optional<double>>& distances, const SonarParameters& parameters,
                                std::int64_t utime) {
  const auto rays = static_cast<std::size_t>(ring_.number * kRaysPerBeam);
  if (distances.size() != rays) {
    throw std::invalid_argument("SonarModel: " + std::to_string(distances.size()) +
                                " distances; allowed: " + std::to_string(rays));
  }
  SonarReading reading{utime, ring_.min_range, ring_.max_range, ring_.beam_width, {}};
  const std::uint64_t scan_seed = seed_for(seed_, streams::kSonarScan, scans_++);
  for (int sonar = 0; sonar < ring_.number; ++sonar) {
    RandomBits bits(seed_for(scan_seed, streams::kSonarScan, static_cast<std::uint64_t>(sonar)));
    SonarEchoReading echo;
    echo.X_RS = ring_.pose(sonar);
    echo.range = ring_.max_range;

    const auto first = distances.begin() + static_cast<std::ptrdiff_t>(sonar) * kRaysPerBeam;
    for (auto distance = first; distance != first + kRaysPerBeam; ++distance) {
      echo.range = std::min(echo.range, distance->value_or(ring_.max_range));
    }
    const bool lost = bits.uniform() < parameters.dropout;
    echo.heard = echo.range < ring_.max_range && !lost;
    if (echo.heard) {
      echo.range = std::clamp(echo.range + parameters.noise * bits.gaussian(), ring_.min_range, ring_.max_range);
    } else {
      echo.range = ring_.max_range;
    }
    reading.echoes.push_back(echo);
  }
  return reading;
}

}  // namespace markservo::simulator
