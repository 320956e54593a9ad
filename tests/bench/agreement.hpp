#pragma once

// Whether ours and the chain of OpenCV's parts give the same answers, so that speed is not bought with them.

#include <string>
#include <vector>

#include "tests/bench/baseline_at.hpp"
#include "tests/bench/ours.hpp"
#include "tests/scenes/stereo_scene.hpp"

namespace markservo::bench {

struct AgreementBounds {
  double missed_share = 0.0;      // of all marks, by either
  double mask_iou = 0.97;         // median, at least
  double mask_iou_worst = 0.90;   // at least: a wrong blob has 0
  double box_px = 2.0;            // 95th percentile of the largest difference of an edge, at most
  double disparity_px = 0.12;     // 95th percentile of the difference, at most
  double ours_error_px = 0.06;    // 95th percentile against truth, at most
  double theirs_error_px = 0.12;  // likewise: else the baseline is not set up as it should be
};

struct Agreement {
  int marks = 0;             // looked for: pairs times marks
  int missed_by_ours = 0;    // not located
  int missed_by_theirs = 0;  // fewer than 6 matches
  double mask_iou = 0.0;     // median; intersection over union of the marks' pixels, both images
  double mask_iou_worst = 0.0;
  double box_px = 0.0;         // 95th percentiles from here on
  double disparity_px = 0.0;   // ours against theirs, of the marks' centres
  double ours_error_px = 0.0;  // against truth, of the marks' centres
  double theirs_error_px = 0.0;

  // One line for every bound that is broken.
  std::vector<std::string> complaints(const AgreementBounds& bounds) const;
};

// The disparity at a mark's centre: ours from the place it gives; theirs is the median over its matches of what each is
// off the mark's true plane, added to the true centre's.
Agreement compare(const std::vector<scenes::StereoPair>& pairs, const geometry::StereoCamera& camera, Ours& ours,
                  BaselineAt& theirs);

}  // namespace markservo::bench
