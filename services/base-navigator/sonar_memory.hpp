#pragma once

#include <cstdint>
#include <deque>
#include <vector>

#include "services/base-navigator/clearance.hpp"
#include "services/base-navigator/flat_face.hpp"
#include "services/base-navigator/navigator_types.hpp"
#include "services/base-navigator/odometry_track.hpp"

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

  std::vector<SeenPoint> points(const SonarMemoryParameters& parameters, const OdometryTrack& track) const;

 private:
  struct Scan {
    std::int64_t utime;
    int epoch;
    std::vector<SeenPoint> points_O;  // m, in the track's frame O
  };

  std::deque<Scan> scans_;
};

}  // namespace markservo::base_navigator
