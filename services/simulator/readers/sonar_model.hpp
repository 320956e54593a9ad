#pragma once

// The ring of sonars: where its beams go, and what it makes of the distances that they meet.

#include <cstdint>
#include <optional>
#include <vector>

#include "common/robot/robot_description.hpp"
#include "services/simulator/readers/ray.hpp"
#include "services/simulator/readers/sonar_reading.hpp"

namespace markservo::simulator {

struct SonarParameters {
  double noise = 0.01;    // m, standard deviation of a range
  double dropout = 0.02;  // share of echoes that are lost, [0, 1]
};

class SonarModel {
 public:
  static constexpr int kRaysPerBeam = 9;  // 4 degrees apart in a beam of 30: 9 cm at 1.3 m

  SonarModel(const robot::SonarRingDescription& ring, std::uint64_t seed) : ring_(ring), seed_(seed) {}

  // The rays of all beams in R: kRaysPerBeam for sonar 0, then for sonar 1, ...; level, at the ring's height.
  std::vector<Ray> rays() const;

  // What is heard at `utime` (us) when the rays meet something after `distances` (m), or nothing: the nearest of each
  // beam, with noise and losses. Throws std::invalid_argument unless there is one for every ray.
  SonarReading listen(const std::vector<std::optional<double>>& distances, const SonarParameters& parameters,
                      std::int64_t utime);

 private:
  robot::SonarRingDescription ring_;
  std::uint64_t seed_;
  std::uint64_t scans_ = 0;
};

}  // namespace markservo::simulator
