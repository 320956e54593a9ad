#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <vector>

#include "services/base-navigator/kinematics/odometry_track.hpp"
#include "services/base-navigator/navigator_types.hpp"
#include "services/base-navigator/obstacles/flat_face.hpp"
#include "services/base-navigator/obstacles/free_path.hpp"

namespace markservo::base_navigator {

struct SonarMemoryParameters {
  FlatFaceParameters faces;
  int scans = 3;           // kept: so that no lost echo, nor two in a row, opens the way
  double kept = 0.6;       // s; older ones are dropped however few there are
  double sight = 2.5;      // m; farther echoes limit nothing: braking from 1.2 m/s takes 1.5 m
  double arc_step = 0.05;  // m, between the points that stand for an echo's arc; far below the robot's width
  int arc_steps = 64;      // at most, on each arc, however wide a beam is told to be: memory and time are bounded by it
};

// What the last few scans saw, as points around where the robot is now.
//
// A sonar's cone is wide: an echo at a range may come from anywhere on the arc of its beam, so the whole arc counts,
// only a flat face that three neighbours agree on is taken for where it is. An echo at the least range says that
// something is there or nearer (SeenPoint::blind_range).
class SonarMemory {
 public:
  // Takes a scan unless the track does not know where the robot was; false then.
  bool add(const SonarMemoryParameters& parameters, const SonarScanSample& scan, const OdometryTrack& track);

  // us, of the newest scan; 0 when there is none in the track's present frame.
  std::int64_t newest_utime(const OdometryTrack& track) const;

  // For a robot that keeps `clearance` (m, 0 or more) from them: flat faces push arcs out by less than that only, so
  // that it keeps off what one may hide too.
  std::vector<SeenPoint> points(const SonarMemoryParameters& parameters, const OdometryTrack& track,
                                double clearance) const;

 private:
  struct ArcPoint {
    SeenPoint at_range;                                  // in O, at the echo's own range
    Eigen::Vector2d pushed_O = Eigen::Vector2d::Zero();  // m, from there to the flat face
  };

  struct Scan {
    std::int64_t utime;
    int epoch;
    std::vector<ArcPoint> points_O;  // in the track's frame O
  };

  static void add_arc(const SonarMemoryParameters& parameters, const SonarScanSample& scan, const SonarReading& reading,
                      const std::optional<FlatFace>& face, const geometry::PlanePose& X_OR,
                      std::vector<ArcPoint>& points_O);

  std::deque<Scan> scans_;
};

}  // namespace markservo::base_navigator
