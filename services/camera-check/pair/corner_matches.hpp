#pragma once

// Points that both pictures of a pair show, found without believing how the cameras stand.

#include <opencv2/core.hpp>
#include <vector>

namespace markservo::camera_check {

struct CornerMatch {
  cv::Point2d left;   // px
  cv::Point2d right;  // px
};

struct PairMatches {
  int num_corners = 0;  // of the left picture that stand out of the noise and were looked for in the right one
  std::vector<CornerMatch> matches;
};

struct MatchParameters {
  int max_corners = 300;         // enough for medians of thirds of the picture
  double columns_share = 0.4;    // of the width, to either side: an exchanged pair has its disparities the other way
  double rows_share = 0.05;      // of the height, up and down
  double least_likeness = 0.85;  // normalised correlation of two windows that show the same
  double least_noise = 1.0;      // levels; fainter than what such noise hides is shading
  double least_lead = 0.05;      // before the next best place: repeated patterns match anywhere
};

// Corners of the left picture in the right one, by correlation of windows, each way: what is found there must find
// back. Both are 8 bit, one channel, of one size. Rows to some 0.1 px in pictures of 640 px.
PairMatches match_corners(const cv::Mat& left, const cv::Mat& right, const MatchParameters& parameters = {});

}  // namespace markservo::camera_check
