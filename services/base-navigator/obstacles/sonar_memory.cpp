#include "services/base-navigator/obstacles/sonar_memory.hpp"

#include <algorithm>
#include <cmath>

namespace markservo::base_navigator {
namespace {

using geometry::PlanePose;

constexpr double kScanTolerance_s = 0.1;      // a scan may come so much before or after the odometry that is known
constexpr double kRangeResolution_m = 0.001;  // what reads as the least range

}  // namespace

void SonarMemory::add_arc(const SonarMemoryParameters& parameters, const SonarScanSample& scan,
                          const SonarReading& reading, const std::optional<FlatFace>& face, const PlanePose& X_OR,
                          std::vector<ArcPoint>& points_O) {
  const double range = std::max(reading.range, scan.min_range);
  const bool blind = range <= scan.min_range + kRangeResolution_m;
  const PlanePose X_OS = X_OR * reading.X_RS;
  // Bounded before it becomes an integer: what a scan tells may be too large for one.
  const double wanted = std::ceil(range * scan.beam_width / parameters.arc_step);
  const int steps = static_cast<int>(std::clamp(wanted, 2.0, static_cast<double>(std::max(2, parameters.arc_steps))));
  for (int i = 0; i <= steps; ++i) {
    const double angle = scan.beam_width * (static_cast<double>(i) / steps - 0.5);
    const double ray = face && !blind ? range_to_face(parameters.faces, reading, *face, angle) : range;
    const Eigen::Vector2d along_S(std::cos(angle), std::sin(angle));
    const Eigen::Vector2d p_O = X_OS * (range * along_S);
    points_O.push_back({{p_O, blind ? scan.min_range : 0.0}, X_OS * (ray * along_S) - p_O});
  }
}

bool SonarMemory::add(const SonarMemoryParameters& parameters, const SonarScanSample& scan,
                      const OdometryTrack& track) {
  const auto X_OR = track.at(scan.utime, kScanTolerance_s);
  if (!X_OR) return false;
  if (!scans_.empty() && scans_.back().epoch == track.epoch() && scan.utime <= scans_.back().utime) return false;
  Scan seen{scan.utime, track.epoch(), {}};
  const auto faces = flat_faces(parameters.faces, scan);
  for (std::size_t i = 0; i < scan.readings.size(); ++i) {
    const SonarReading& reading = scan.readings[i];
    if (!reading.heard || std::max(reading.range, scan.min_range) > parameters.sight) continue;
    add_arc(parameters, scan, reading, faces[i], *X_OR, seen.points_O);
  }
  scans_.push_back(std::move(seen));
  while (scans_.size() > static_cast<std::size_t>(std::max(1, parameters.scans))) scans_.pop_front();
  return true;
}

std::int64_t SonarMemory::newest_utime(const OdometryTrack& track) const {
  return scans_.empty() || scans_.back().epoch != track.epoch() ? 0 : scans_.back().utime;
}

std::vector<SeenPoint> SonarMemory::points(const SonarMemoryParameters& parameters, const OdometryTrack& track,
                                           double clearance) const {
  const double gain = std::max(0.0, clearance - parameters.faces.noise);
  std::vector<SeenPoint> points_R;
  const PlanePose X_RO = track.newest().inverse();
  for (const Scan& scan : scans_) {
    if (scan.epoch != track.epoch() || seconds_between(scan.utime, track.newest_utime()) > parameters.kept) continue;
    for (const ArcPoint& point : scan.points_O) {
      const double pushed = point.pushed_O.norm();
      const double part = pushed > gain ? gain / pushed : 1.0;
      points_R.push_back({X_RO * (point.at_range.p_R + part * point.pushed_O), point.at_range.blind_range});
    }
  }
  return points_R;
}

}  // namespace markservo::base_navigator
