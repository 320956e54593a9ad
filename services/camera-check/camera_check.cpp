#include "services/camera-check/camera_check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "services/camera-check/picture/picture_blur.hpp"

namespace markservo::camera_check {
namespace {

using Findings = std::vector<Finding>;

void well(Findings& findings, std::string what) {
  findings.push_back({true, std::move(what), ""});
}

void wrong(Findings& findings, std::string what, std::string mend) {
  findings.push_back({false, std::move(what), std::move(mend)});
}

cv::Mat grey_of(const cv::Mat& bgr) {
  cv::Mat grey;
  cv::cvtColor(bgr, grey, cv::COLOR_BGR2GRAY);
  return grey;
}

bool is_dark(const PictureReport& picture, const VerdictParameters& parameters) {
  return picture.light.bright_level < parameters.dark_level;
}

// Returns whether what the pictures show can be judged.
bool judge_light(const PairReport& report, const VerdictParameters& parameters, Findings& findings) {
  bool can_be_judged = true;
  bool well_lit = true;
  for (const auto& [name, picture] : {std::pair{"left", &report.left}, std::pair{"right", &report.right}}) {
    if (is_dark(*picture, parameters)) {
      can_be_judged = false;
      wrong(findings,
            fmt::format("the {} picture is dark: 95% of it are below level {:.0f} of 255", name,
                        picture->light.bright_level),
            "take the cap off, switch a light on, or raise the exposure (stereo-camera --exposure)");
    } else if (picture->light.blown_share > parameters.blown_share) {
      well_lit = false;
      wrong(findings,
            fmt::format("the {} picture is too bright: {:.0f}% of it have lost their colour", name,
                        100.0 * picture->light.blown_share),
            "lower the exposure (stereo-camera --exposure), or the light");
    }
  }
  if (!can_be_judged || !well_lit) return can_be_judged;
  const double left = std::max(report.left.light.middle_level, parameters.side_floor);
  const double right = std::max(report.right.light.middle_level, parameters.side_floor);
  if (std::max(left, right) > parameters.side_ratio * std::min(left, right)) {
    wrong(
        findings,
        fmt::format("the {} picture is much darker than the other: their medians are {:.0f} (left) and {:.0f} (right)",
                    left < right ? "left" : "right", report.left.light.middle_level, report.right.light.middle_level),
        "give both cameras the same exposure (stereo-camera --exposure), and look for dirt and reflections");
  } else {
    well(findings, fmt::format("light: medians {:.0f} (left) and {:.0f} (right) of 255", report.left.light.middle_level,
                               report.right.light.middle_level));
  }
  return true;
}

void judge_blur(const PairReport& report, const VerdictParameters& parameters, Findings& findings) {
  for (const auto& [name, picture] : {std::pair{"left", &report.left}, std::pair{"right", &report.right}}) {
    if (!picture->blur_px) {
      well(findings, fmt::format("the {} picture has too few edges to tell whether it is sharp", name));
    } else if (*picture->blur_px > parameters.blurred_px) {
      wrong(findings,
            fmt::format("the {} picture is blurred: its sharpest edges by {:.1f} px", name, *picture->blur_px),
            "focus or clean the lens, hold the camera still, or shorten the exposure (stereo-camera --exposure)");
    } else {
      well(findings,
           fmt::format("the {} picture is sharp: its edges are blurred by {:.1f} px", name, *picture->blur_px));
    }
  }
}

std::string told(const RowOffsets& rows) {
  std::string text = fmt::format("{:.1f} px {}", std::abs(rows.middle_px), rows.middle_px < 0.0 ? "higher" : "lower");
  if (rows.left_px && rows.right_px) {
    text += fmt::format(" ({:+.1f} px among the leftmost points, {:+.1f} among the rightmost)", *rows.left_px,
                        *rows.right_px);
  }
  return text;
}

void judge_rows(const PairGeometry& geometry, const VerdictParameters& parameters, Findings& findings) {
  if (std::abs(geometry.rows.worst_px()) > parameters.rows_off_px) {
    wrong(findings, "rows are off: the right picture shows the same point " + told(geometry.rows),
          "calibrate anew: a camera was moved, or the calibration is of other cameras or another size");
  } else {
    well(findings, fmt::format("rows agree within {:.1f} px, by {} points", std::abs(geometry.rows.worst_px()),
                               geometry.num_matches));
  }
}

void judge_geometry(const PairGeometry& geometry, const VerdictParameters& parameters, Findings& findings) {
  if (geometry.num_matches < parameters.least_matches) {
    const std::string count = fmt::format("{} of {} points match", geometry.num_matches, geometry.num_corners);
    if (geometry.num_corners < parameters.least_corners) {
      well(findings, "too little to be seen to tell how the cameras stand: " + count);
    } else {
      wrong(findings, "the two pictures show different things: " + count,
            "let both cameras look at the same things, upright and from the same side, and name them in that order");
    }
    return;
  }
  if (geometry.is_one_picture) {
    wrong(findings, "both pictures are the same", "name two cameras: one was named twice");
    return;
  }
  const double share = 100.0 * geometry.behind_share;
  if (geometry.behind_share >= parameters.exchanged_behind) {
    wrong(findings,
          fmt::format("left and right are exchanged: {:.0f}% of {} points have a negative disparity", share,
                      geometry.num_matches),
          "exchange --left-device and --right-device (--left and --right of files)");
    return;
  }
  judge_rows(geometry, parameters, findings);
  if (geometry.behind_share > parameters.most_behind) {
    wrong(findings,
          fmt::format("columns are off: {:.0f}% of {} points seem behind infinity", share, geometry.num_matches),
          "calibrate anew: a camera was turned, or the calibration is of other cameras");
  }
}

}  // namespace

PairReport report_of(const cv::Mat& left, const cv::Mat& right, double infinity_px) {
  const cv::Mat left_grey = grey_of(left);
  const cv::Mat right_grey = grey_of(right);
  PairReport report;
  report.left = {light_of(left_grey), blur_of(left_grey)};
  report.right = {light_of(right_grey), blur_of(right_grey)};
  report.geometry = geometry_of(match_corners(left_grey, right_grey), infinity_px);
  return report;
}

std::vector<Finding> findings_of(const PairReport& report, const VerdictParameters& parameters) {
  Findings findings;
  if (!judge_light(report, parameters, findings)) return findings;
  judge_blur(report, parameters, findings);
  judge_geometry(report.geometry, parameters, findings);
  return findings;
}

}  // namespace markservo::camera_check
