#pragma once

// By how much the clocks of two videos of one scene differ, from what moves in them.

#include <cstdint>
#include <vector>

#include "services/stereo-camera/files/motion_signal.hpp"

namespace markservo::stereo_camera {

enum class OffsetStatus {
  kFound,
  kTooShort,   // fewer than `least_steps` steps overlap at any offset
  kTooLittle,  // too little motion, or none that both videos have in common
  kAmbiguous,  // motion repeats itself: two offsets fit nearly as well
};

struct OffsetEstimate {
  OffsetStatus status = OffsetStatus::kTooShort;
  double offset_s = 0.0;      // right video's time minus left's at the same moment
  double correlation = 0.0;   // of both motions at that offset, -1 to 1
  double rival = 0.0;         // the best correlation at another offset
  double overlap_s = 0.0;     // how much of both was compared
  double significance = 0.0;  // of the correlation, in standard deviations of chance
};

struct OffsetParameters {
  double max_offset_s = 30.0;      // two people start two cameras within this
  int least_steps = 10;            // in the overlap; and at least half of the shorter video
  int steps_per_period = 4;        // of the search; the peak between them is found by a parabola
  double longest_step = 1.75;      // periods; where pictures were lost, how much moved in between is not known
  double least_correlation = 0.5;  // noise that both see alike by chance stays below
  // Of the simulated hands of the tests, over 10 s: one hand seen by both 8 and more, two hands up to 5.
  double least_significance = 6.0;
  double least_lead = 0.08;  // of the best correlation over any at another offset
};

// Pearson's correlation of both motions at every offset of the search, of their square roots, so that the one largest
// motion does not decide alone; its significance by Fisher's transform, with as many independent values as widths of
// the peak fit into the overlap.
OffsetEstimate estimate_offset(const std::vector<MotionStep>& left, const std::vector<MotionStep>& right,
                               const OffsetParameters& parameters);

}  // namespace markservo::stereo_camera
