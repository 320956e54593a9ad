#include "services/base-navigator/obstacles/flat_face.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace markservo::base_navigator {
namespace {

using geometry::wrapped;

constexpr int kDirections = 31;       // that are tried, over the neighbours' own spread
constexpr double kFlattestRay = 0.3;  // cosine against the normal, below which a ray runs along the face

// m, the distance from R's origin of a face with that normal, of which this echo is the nearest point in the beam.
double distance_told(const SonarReading& reading, double beam_width, double normal) {
  const double off = std::abs(wrapped(reading.X_RS.heading - normal));
  const double ray = std::max(0.0, off - 0.5 * beam_width);
  return reading.range * std::cos(ray) + reading.X_RS.x * std::cos(normal) + reading.X_RS.y * std::sin(normal);
}

std::optional<FlatFace> explain(const FlatFaceParameters& parameters, double beam_width,
                                const std::array<const SonarReading*, 3>& readings) {
  for (const SonarReading* reading : readings) {
    if (!reading->heard) return std::nullopt;
  }
  const double middle = readings[1]->X_RS.heading;
  const double reach = std::abs(wrapped(readings[2]->X_RS.heading - middle));
  std::optional<FlatFace> best;
  double least = parameters.spread;
  for (int i = 0; i < kDirections; ++i) {
    const double normal = middle + reach * (2.0 * i / (kDirections - 1) - 1.0);
    std::array<double, 3> told{};
    std::transform(readings.begin(), readings.end(), told.begin(),
                   [&](const SonarReading* reading) { return distance_told(*reading, beam_width, normal); });
    const auto [nearest, farthest] = std::minmax_element(told.begin(), told.end());
    if (*farthest - *nearest >= least) continue;
    least = *farthest - *nearest;
    best = FlatFace{normal, (told[0] + told[1] + told[2]) / 3.0};
  }
  return best;
}

}  // namespace

std::vector<std::optional<FlatFace>> flat_faces(const FlatFaceParameters& parameters, const SonarScanSample& scan) {
  const std::size_t number = scan.readings.size();
  std::vector<std::optional<FlatFace>> faces(number);
  if (number < 3) return faces;
  for (std::size_t i = 0; i < number; ++i) {
    const std::size_t before = (i + number - 1) % number;
    const std::size_t after = (i + 1) % number;
    const auto face =
        explain(parameters, scan.beam_width, {&scan.readings[before], &scan.readings[i], &scan.readings[after]});
    if (!face) continue;
    faces[i] = face;
    // The neighbours keep a face of their own, of which they are the middle.
    for (const std::size_t neighbour : {before, after}) {
      if (!faces[neighbour]) faces[neighbour] = face;
    }
  }
  return faces;
}

double range_to_face(const FlatFaceParameters& parameters, const SonarReading& reading, const FlatFace& face,
                     double angle) {
  const double against = std::cos(reading.X_RS.heading + angle - face.normal);
  if (against < kFlattestRay) return reading.range + parameters.gain;
  const double apart = face.distance - reading.X_RS.x * std::cos(face.normal) - reading.X_RS.y * std::sin(face.normal);
  return std::clamp(apart / against, reading.range, reading.range + parameters.gain);
}

}  // namespace markservo::base_navigator
