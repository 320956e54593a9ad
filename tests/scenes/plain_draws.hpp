#pragma once

// Draws of plain marks before a plain ground, through the real detector and locator, held against the truth and against
// the least error that there can be.

#include <Eigen/Core>
#include <functional>
#include <string>
#include <vector>

#include "services/target-locator/mark_locator.hpp"
#include "tests/scenes/plain_mark.hpp"

namespace markservo::scenes {

struct PlainCase {
  PlainForm form = PlainForm::kSquare;
  double width_px = 60.0;  // of the mark in the image, where it faces the cameras
  double slant_deg = 0.0;  // of its normal from the cameras' axis; of no meaning for a ball

  std::string name() const;
};

// All that are measured: three sizes, facing and slanted, squares (turned in their plane any way) and discs; balls.
std::vector<PlainCase> plain_cases();

struct PlainDrawParameters {
  double sigma = 3.0;          // grey levels of noise in each channel
  double contrast_min = 60.0;  // grey levels: length of the difference of the two colours' B, G, R
  double contrast_max = 150.0;
  double blur_min_px = 0.5;  // sigma of lens and pixel together
  double blur_max_px = 1.0;
  int jpeg_quality = 0;  // 1 to 100, as the frames on the bus may be packed; 0: not at all
};

struct PlainDraw {
  unsigned seed = 0;
  double contrast = 0.0;  // grey levels
  double blur_px = 0.0;   // sigma of lens and pixel together
  bool detected = false;  // in both views
  target_locator::Location location;
  Eigen::Vector3d error = Eigen::Vector3d::Zero();  // m; valid when located
  double nees = 0.0;                                // of the error by the published covariance; 3 degrees of freedom
  double least_rms = 0.0;                           // m, of the error: the Cramer-Rao bound

  bool located() const { return location.status == target_locator::Status::kLocated; }
};

std::vector<PlainDraw> draw_plain_marks(const PlainCase& what, int count, unsigned seed,
                                        const PlainDrawParameters& parameters,
                                        const std::function<void()>& advance = {});

struct PlainTotals {
  int drawn = 0;
  int missed = 0;
  int not_by_outline = 0;  // located, but by another cue
  double rms = 0.0;        // m, of the located
  double least_rms = 0.0;  // m, the bound for these
  double mean_nees = 0.0;

  double ratio() const { return rms / least_rms; }
};

PlainTotals totals_of(const std::vector<PlainDraw>& draws);

}  // namespace markservo::scenes
