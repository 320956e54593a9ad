#pragma once

// What two cameras show, measured, and what is wrong with it.

#include <opencv2/core.hpp>
#include <optional>
#include <string>
#include <vector>

#include "services/camera-check/pair/pair_geometry.hpp"
#include "services/camera-check/picture/picture_light.hpp"

namespace markservo::camera_check {

struct PictureReport {
  PictureLight light;
  std::optional<double> blur_px;  // sigma; nothing where the picture has too few edges to tell
};

struct PairReport {
  PictureReport left;
  PictureReport right;
  PairGeometry geometry;
};

// One thing that was looked at.
struct Finding {
  bool ok = true;
  std::string what;
  std::string mend;  // what a person can do; empty where nothing has to be done
};

struct VerdictParameters {
  double dark_level = 50.0;  // of 255; below it colours are noise: a channel's least step is 5% of the saturation
  double blown_share = 0.5;  // of the pixels without colour
  double side_ratio = 2.0;   // of the sides' medians: the same colour is another one then
  double side_floor = 10.0;  // levels; medians below it have no ratio worth the name
  double blurred_px = 2.0;   // a lens in focus shows 0.5 to 1.2; twice that doubles what a match is unsure by
  double rows_off_px = 1.0;  // mark-detector takes 3 px for one mark, target-locator matches along rows
  int least_matches = 20;    // fewer say nothing of how the cameras stand
  int least_corners = 50;    // of a picture in which there is something to be matched
  double most_behind = 0.2;  // of the points; a few are false matches
  double exchanged_behind = 0.8;
};

// `left` and `right`: 8-bit BGR pictures of one size, rectified. `infinity_px`: cx_left - cx_right.
PairReport report_of(const cv::Mat& left, const cv::Mat& right, double infinity_px);

// What was looked at and how it is, the light first, since nothing can be said of what is dark.
std::vector<Finding> findings_of(const PairReport& report, const VerdictParameters& parameters = {});

}  // namespace markservo::camera_check
